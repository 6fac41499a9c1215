import type { ParsedMode } from '../../definition/parse-module.ts';
import { FreeDriver } from './free-driver.ts';
import { FrequencyDriver } from './frequency-driver.ts';
import type { ModeDriver, RunHost } from './mode-driver.ts';
import { TriggerDriver, type InputMarks } from './trigger-driver.ts';

/** In lockstep the session asks for each run. [PM-27] */
const LOCKSTEP_DRIVER: ModeDriver = {
  waiting: 0,
  start() {},
  stop() {},
  handleRunEnd() {},
  handleMark() {},
};

/** The driver of a mode. */
export function createDriver(
  mode: ParsedMode,
  host: RunHost,
  marks: InputMarks,
  maxFreeHz: number,
): ModeDriver {
  switch (mode.kind) {
    case 'frequency':
      return new FrequencyDriver(host, mode.hertz);
    case 'trigger':
      return new TriggerDriver(host, marks, mode);
    case 'free':
      return new FreeDriver(host, maxFreeHz);
    case 'lockstep':
      return LOCKSTEP_DRIVER;
  }
}
