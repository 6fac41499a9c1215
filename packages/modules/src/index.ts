export { averagePositions } from './average-positions/average-positions.ts';
export { bodyPose } from './body-pose/body-pose.ts';
export { cameraCalibration } from './camera-calibration/camera-calibration.ts';
export { clock } from './clock/clock.ts';
export { counter } from './counter/counter.ts';
export { EXAMPLE_SESSIONS } from './examples/example-sessions.ts';
export { handPose } from './hand-pose/hand-pose.ts';
export { httpPoller } from './http-poller/http-poller.ts';
export { imageTools } from './image-tools/image-tools.ts';
export { keyChord } from './key-chord/key-chord.ts';
export { loadGenerator } from './load-generator/load-generator.ts';
export {
  lowPass,
  lowPassQuaternion,
  lowPassVector2,
  lowPassVector3,
  lowPassVector4,
} from './low-pass/low-pass.ts';
export { mapRange } from './map-range/map-range.ts';
export { markerTracking } from './marker-tracking/marker-tracking.ts';
export { mergeVector2, mergeVector3, mergeVector4 } from './merge-vector/merge-vector.ts';
export { mirrorPointer } from './mirror-pointer/mirror-pointer.ts';
export { mix } from './mix/mix.ts';
export { moduleLibrary } from './module-library.ts';
export { MODULES } from './modules.ts';
export { noise } from './noise/noise.ts';
export { objectDetection } from './object-detection/object-detection.ts';
export {
  oneEuroFilter,
  oneEuroFilterQuaternion,
  oneEuroFilterVector2,
  oneEuroFilterVector3,
  oneEuroFilterVector4,
} from './one-euro-filter/one-euro-filter.ts';
export { pickField } from './pick-field/pick-field.ts';
export { pictureEdges } from './picture-edges/picture-edges.ts';
export { positionColor } from './position-color/position-color.ts';
export { speedVector2 } from './speed-vector2/speed-vector2.ts';
export { statistics } from './statistics/statistics.ts';
export { testPicture } from './test-picture/test-picture.ts';
export { threshold } from './threshold/threshold.ts';
export { touchProximity } from './touch-proximity/touch-proximity.ts';
