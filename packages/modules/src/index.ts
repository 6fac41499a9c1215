export { clock } from './clock/clock.ts';
export { EXAMPLE_SESSIONS } from './examples/example-sessions.ts';
export { httpPoller } from './http-poller/http-poller.ts';
export { loadGenerator } from './load-generator/load-generator.ts';
export {
  lowPass,
  lowPassQuaternion,
  lowPassVector2,
  lowPassVector3,
  lowPassVector4,
} from './low-pass/low-pass.ts';
export { mapRange } from './map-range/map-range.ts';
export { mergeVector2, mergeVector3, mergeVector4 } from './merge-vector/merge-vector.ts';
export { mirrorPointer } from './mirror-pointer/mirror-pointer.ts';
export { moduleLibrary } from './module-library.ts';
export { MODULES } from './modules.ts';
export {
  oneEuroFilter,
  oneEuroFilterQuaternion,
  oneEuroFilterVector2,
  oneEuroFilterVector3,
  oneEuroFilterVector4,
} from './one-euro-filter/one-euro-filter.ts';
export { pickField } from './pick-field/pick-field.ts';
export { statistics } from './statistics/statistics.ts';
export { threshold } from './threshold/threshold.ts';
export { touchProximity } from './touch-proximity/touch-proximity.ts';
