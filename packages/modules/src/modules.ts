import type { AnyModuleDefinition } from '@ubii/pm-sandbox';
import { clock } from './clock/clock.ts';
import { httpPoller } from './http-poller/http-poller.ts';
import { loadGenerator } from './load-generator/load-generator.ts';
import {
  lowPass,
  lowPassQuaternion,
  lowPassVector2,
  lowPassVector3,
  lowPassVector4,
} from './low-pass/low-pass.ts';
import { mapRange } from './map-range/map-range.ts';
import { mergeVector2, mergeVector3, mergeVector4 } from './merge-vector/merge-vector.ts';
import { mirrorPointer } from './mirror-pointer/mirror-pointer.ts';
import {
  oneEuroFilter,
  oneEuroFilterQuaternion,
  oneEuroFilterVector2,
  oneEuroFilterVector3,
  oneEuroFilterVector4,
} from './one-euro-filter/one-euro-filter.ts';
import { pickField } from './pick-field/pick-field.ts';
import { statistics } from './statistics/statistics.ts';
import { threshold } from './threshold/threshold.ts';
import { touchProximity } from './touch-proximity/touch-proximity.ts';

/** All modules of the library, by name from a to z. */
export const MODULES: readonly AnyModuleDefinition[] = [
  clock,
  httpPoller,
  loadGenerator,
  lowPass,
  lowPassQuaternion,
  lowPassVector2,
  lowPassVector3,
  lowPassVector4,
  mapRange,
  mergeVector2,
  mergeVector3,
  mergeVector4,
  mirrorPointer,
  oneEuroFilter,
  oneEuroFilterQuaternion,
  oneEuroFilterVector2,
  oneEuroFilterVector3,
  oneEuroFilterVector4,
  pickField,
  statistics,
  threshold,
  touchProximity,
];
