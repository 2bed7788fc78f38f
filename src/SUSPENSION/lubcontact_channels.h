// Where a pair force comes from. This one list feeds the kernel, the computes and the manual.

#ifndef LUBCONTACT_CHANNELS_H
#define LUBCONTACT_CHANNELS_H

namespace lubcontact {

enum Channel {
  CONTACT_NORMAL,
  CONTACT_TANGENTIAL,
  LUBRICATION_NORMAL,
  LUBRICATION_TANGENTIAL,
  SCREENED_REPULSION,
  NUM_CHANNELS
};

inline constexpr const char *CHANNEL_NAME[NUM_CHANNELS] = {"contact/normal", "contact/tangential",
                                                           "lubrication/normal",
                                                           "lubrication/tangential", "repulsion"};

}    // namespace lubcontact

#endif
