import { StudyCheckState, type Study, type StudyCheckList } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { checkRow } from './check-row.ts';
import type { DeviceFinder } from './device-finder.ts';
import type { RateMeter } from './rate-meter.ts';

/** How long a check list is published after it was asked for, milliseconds. [ST-32] */
const WANTED_MS = 10_000;
/** Time until the first rates, milliseconds. */
const MEASURED_MS = 1_000;

/** What check lists work with. */
export interface ChecksContext {
  readonly clock: Clock;
  readonly limits: LimitWatch;
  readonly rates: RateMeter;
  readonly finder: DeviceFinder;
}

/** Check lists of studies, and which of them are wanted. */
export class StudyChecks {
  readonly #context: ChecksContext;
  /** Until when check lists are wanted, by id of the study, monotonic milliseconds. */
  readonly #wanted = new Map<string, number>();

  constructor(context: ChecksContext) {
    this.#context = context;
  }

  /** Ids of studies whose check lists are wanted. */
  wanted(): string[] {
    const nowMs = this.#context.clock.monotonicMs();
    for (const [id, untilMs] of this.#wanted) if (untilMs <= nowMs) this.#wanted.delete(id);
    return [...this.#wanted.keys()];
  }

  /** @throws ServiceError when check lists of too many studies are wanted [ST-32] */
  want(id: string): void {
    const { clock, limits } = this.#context;
    const max = limits.limits.studyChecks;
    const wanted = this.wanted();
    if (!wanted.includes(id) && wanted.length >= max) {
      throw limits.refusal('studyChecks', `more than ${max} studies that are checked at once`);
    }
    this.#wanted.set(id, clock.monotonicMs() + WANTED_MS);
  }

  forget(id: string): void {
    this.#wanted.delete(id);
  }

  /** Takes the rates of now. */
  measure(): void {
    this.#context.rates.measure();
  }

  /** The check list, with rates: waits until there are some when a row needs them. */
  async checkNow(study: Study): Promise<StudyCheckList> {
    const { clock, rates } = this.#context;
    const needsRates = study.devices.some(({ minRateHz }) => minRateHz > 0);
    if (needsRates && !rates.isReady) {
      rates.measure();
      await new Promise<void>((resolve) => clock.after(MEASURED_MS, resolve));
      rates.measure();
    }
    return this.check(study);
  }

  /** The check list by what is known. */
  check(study: Study): StudyCheckList {
    const { clock, finder } = this.#context;
    const rows = study.devices.map((device) => checkRow(device, finder.find(device)));
    return {
      studyId: study.id,
      timeMs: clock.nowMs(),
      rows,
      isReady: rows.every(({ state }) => state === StudyCheckState.STUDY_CHECK_STATE_OK),
    };
  }
}
