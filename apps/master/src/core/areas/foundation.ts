import { Counters } from '../counters/counters.ts';
import { EventLog } from '../counters/event-log.ts';
import { LimitWatch } from '../counters/limit-watch.ts';
import { Hook } from '../hooks/hook.ts';
import { DEFAULT_LIMITS, type Limits } from '../limits/index.ts';
import type { MasterPorts, MasterSettings } from './settings.ts';

/** Parts that every area uses. */
export type Foundation = ReturnType<typeof createFoundation>;

export function createFoundation(
  { clock, ids, log }: Pick<MasterPorts, 'clock' | 'ids' | 'log'>,
  settings: MasterSettings,
) {
  const limits: Limits = { ...DEFAULT_LIMITS, ...settings.limits };
  const events = new EventLog(clock, log, limits);
  return {
    /** Id of this run, a UUID. */
    id: ids.uuid(),
    startedMs: clock.nowMs(),
    settings,
    limits,
    counters: new Counters(),
    events,
    limitWatch: new LimitWatch(limits, clock, log, events),
    /** Called when the master ends: areas end their timers and close what they opened. */
    onClose: new Hook<[]>(),
  };
}
