import type { AnyModuleDefinition } from '@ubii/pm-sandbox';
import { averagePositions } from './average-positions/average-positions.ts';
import { bodyPose } from './body-pose/body-pose.ts';
import { cameraCalibration } from './camera-calibration/camera-calibration.ts';
import { clock } from './clock/clock.ts';
import { counter } from './counter/counter.ts';
import { handPose } from './hand-pose/hand-pose.ts';
import { httpPoller } from './http-poller/http-poller.ts';
import { imageTools } from './image-tools/image-tools.ts';
import { keyChord } from './key-chord/key-chord.ts';
import { loadGenerator } from './load-generator/load-generator.ts';
import {
  lowPass,
  lowPassQuaternion,
  lowPassVector2,
  lowPassVector3,
  lowPassVector4,
} from './low-pass/low-pass.ts';
import { mapRange } from './map-range/map-range.ts';
import { markerTracking } from './marker-tracking/marker-tracking.ts';
import { mergeVector2, mergeVector3, mergeVector4 } from './merge-vector/merge-vector.ts';
import { mirrorPointer } from './mirror-pointer/mirror-pointer.ts';
import { mix } from './mix/mix.ts';
import { noise } from './noise/noise.ts';
import { objectDetection } from './object-detection/object-detection.ts';
import {
  oneEuroFilter,
  oneEuroFilterQuaternion,
  oneEuroFilterVector2,
  oneEuroFilterVector3,
  oneEuroFilterVector4,
} from './one-euro-filter/one-euro-filter.ts';
import { pickField } from './pick-field/pick-field.ts';
import { pictureEdges } from './picture-edges/picture-edges.ts';
import { positionColor } from './position-color/position-color.ts';
import { speedVector2 } from './speed-vector2/speed-vector2.ts';
import { statistics } from './statistics/statistics.ts';
import { testPicture } from './test-picture/test-picture.ts';
import { threshold } from './threshold/threshold.ts';
import { touchProximity } from './touch-proximity/touch-proximity.ts';

/** All modules of the library, sorted by name. */
export const MODULES: readonly AnyModuleDefinition[] = [
  averagePositions,
  bodyPose,
  cameraCalibration,
  clock,
  counter,
  handPose,
  httpPoller,
  imageTools,
  keyChord,
  loadGenerator,
  lowPass,
  lowPassQuaternion,
  lowPassVector2,
  lowPassVector3,
  lowPassVector4,
  mapRange,
  markerTracking,
  mergeVector2,
  mergeVector3,
  mergeVector4,
  mirrorPointer,
  mix,
  noise,
  objectDetection,
  oneEuroFilter,
  oneEuroFilterQuaternion,
  oneEuroFilterVector2,
  oneEuroFilterVector3,
  oneEuroFilterVector4,
  pickField,
  pictureEdges,
  positionColor,
  speedVector2,
  statistics,
  testPicture,
  threshold,
  touchProximity,
];
