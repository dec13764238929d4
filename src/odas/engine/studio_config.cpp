// SPDX-License-Identifier: MIT
#include "odas/engine/studio_config.hpp"

namespace odas {

Schema CameraConfig::schema() {
  using C = CameraConfig;
  static const std::vector<Field> fields{
      field<&C::url>("url", "", kAny, "address of an MJPEG stream or a picture; absent: no camera"),
      field<&C::width>("width", "pixels", {1, 16384}, "width of the picture that fx and cx are of"),
      field<&C::height>("height", "pixels", {1, 16384}, "height of the picture that fy and cy are of"),
      field<&C::fx>("fx", "pixels", kPositive, "focal length, across"),
      field<&C::fy>("fy", "pixels", kPositive, "focal length, down"),
      field<&C::cx>("cx", "pixels", kAny, "where the axis meets the picture, from the left"),
      field<&C::cy>("cy", "pixels", kAny, "where the axis meets the picture, from the top"),
      field<&C::position>("position", "m", kAny, "place of the camera in the frame of the array"),
      field<&C::rotation>("rotation", "degrees", kAny,
                          "roll, pitch and yaw of the camera; 0, 0, 0 looks along +x of the array, z up"),
  };
  return fields;
}

Schema EventsConfig::schema() {
  using C = EventsConfig;
  static const std::vector<Field> fields{
      field<&C::url>("url", "", kAny,
                     "is sent a POST when a source appears, disappears or changes its class"),
      field<&C::timeout>("timeout", "s", {0.1, 60}, "how long its answer is waited for"),
  };
  return fields;
}

Schema SpeechConfig::schema() {
  static const std::vector<Field> fields{
      field<&SpeechConfig::command>(
          "command", "", kAny,
          "program that reads a voice on its input and writes JSON lines of text; absent: none"),
  };
  return fields;
}

Schema StudioConfig::schema() {
  using C = StudioConfig;
  static const std::vector<Field> fields{
      field<&C::ip>("ip", "", kAny, "address to listen at; any but this machine's own wants a token"),
      field<&C::port>("port", "", {0, 65535}, "TCP port; 0: the system chooses one"),
      field<&C::token>("token", "", kAny, "what an operator's browser must say; absent: made at the start"),
      field<&C::viewer_token>("viewerToken", "", kAny, "what a browser must say to see and hear only"),
      field<&C::certificate>("certificate", "", kAny, "PEM file with the certificate: TLS"),
      field<&C::key>("key", "", kAny, "PEM file with the certificate's key"),
      field<&C::hosts>("hosts", "", kAny, "names of this machine that browsers may use beside its addresses"),
      field<&C::recordings>("recordings", "", kAny, "folder of recordings and sessions; absent: the user's"),
      field<&C::preroll>("preroll", "s", {0, 60},
                         "how much of a voice before the button is in its recording"),
      field<&C::camera>("camera", "", kAny, "a camera that the page lays the sources over"),
      field<&C::events>("events", "", kAny, "whom to tell when sources come and go"),
      field<&C::speech>("speech", "", kAny, "a program that writes down what is said"),
  };
  return fields;
}

}  // namespace odas
