// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "odas/base/field.hpp"

namespace odas {

/// A camera whose picture the page lays the sources over: a pinhole, looking along its own +z, +x to the
/// right and +y down, as is usual.
struct CameraConfig {
  std::string url;                  // of an MJPEG stream or a picture; "": no camera
  int width = 640, height = 480;    // pixels that the numbers below are of
  float fx = 550, fy = 550;         // focal lengths, pixels
  float cx = 320, cy = 240;         // where the axis meets the picture, pixels
  std::array<float, 3> position{};  // of the camera in the frame of the array, m
  std::array<float, 3> rotation{};  // roll, pitch, yaw: 0 looks along +x of the array, degrees
  static Schema schema();
};

/// Whom to tell when sources come and go.
struct EventsConfig {
  std::string url;    // is sent a POST for each event; "": nobody
  float timeout = 5;  // s
  static Schema schema();
};

/// A program that turns speech into text.
struct SpeechConfig {
  std::string command;  // "": none
  static Schema schema();
};

/// The page in the browser: section `studio`. Read by `odas studio` and `odas live --studio` alone.
struct StudioConfig {
  std::string ip = "127.0.0.1";
  int port = 8080;
  std::string token;               // of operators; away from loopback one is made if it is ""
  std::string viewer_token;        // of viewers; "": there are none
  std::string certificate, key;    // PEM files: TLS
  std::vector<std::string> hosts;  // names under which a browser may come, beyond addresses of this machine
  std::string recordings;          // folder; "": the user's
  float preroll = 1;               // s
  CameraConfig camera;
  EventsConfig events;
  SpeechConfig speech;
  static Schema schema();
};

}  // namespace odas
