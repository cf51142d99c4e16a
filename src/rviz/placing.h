// Where a message is in the view.
#pragma once

#include <OGRE/OgreQuaternion.h>
#include <OGRE/OgreVector3.h>
#include <rviz/display.h>
#include <rviz/display_context.h>
#include <rviz/frame_manager.h>
#include <std_msgs/Header.h>

namespace ice_ice_baby {

struct Place {
  Ogre::Vector3 position;
  Ogre::Quaternion orientation;
};

/// Place of the frame of a message in the fixed frame. The status of the display says whether tf
/// has it. @returns whether it has
inline bool findPlace(rviz::Display& display, rviz::DisplayContext& context,
                      const std_msgs::Header& header, Place& place) {
  const bool found =
      context.getFrameManager()->getTransform(header, place.position, place.orientation);
  const QString frame = QString::fromStdString(header.frame_id);
  display.setStatus(found ? rviz::StatusProperty::Ok : rviz::StatusProperty::Error, "Transform",
                    found ? QString("OK")
                          : QString("none from [%1] to [%2]").arg(frame, context.getFixedFrame()));
  return found;
}

}  // namespace ice_ice_baby
