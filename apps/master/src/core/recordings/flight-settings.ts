import { ServiceError, type FlightRecorderSettings } from '@ubii/proto';
import type { LimitWatch } from '../counters/limit-watch.ts';

/** What the flight recorder keeps unless the operator chose otherwise. [RC-30] */
export const DEFAULT_FLIGHT_RECORDER: FlightRecorderSettings = {
  isOn: true,
  minutes: 5,
  maxBytes: 64 * 1024 * 1024,
  withImages: true,
};

const MS_PER_MINUTE = 60_000;

/** What the flight recorder is to keep. [RC-31] */
export class FlightSettings {
  readonly #limits: LimitWatch;
  #settings: FlightRecorderSettings;
  #isTold = false;

  constructor(settings: FlightRecorderSettings, limits: LimitWatch) {
    this.#settings = settings;
    this.#limits = limits;
  }

  get settings(): FlightRecorderSettings {
    return this.#settings;
  }

  /** The settings, once: for the recorder that does not know them. */
  takeUntold(): FlightRecorderSettings | undefined {
    if (this.#isTold) return undefined;
    this.#isTold = true;
    return this.#settings;
  }

  /** @throws ServiceError for impossible numbers, or when it is too much */
  change(wanted: FlightRecorderSettings): FlightRecorderSettings {
    const minutes = wanted.minutes || this.#settings.minutes;
    const maxBytes = wanted.maxBytes || this.#settings.maxBytes;
    if (!(minutes > 0 && maxBytes > 0)) {
      throw new ServiceError(
        'invalid_argument',
        `The flight recorder cannot keep ${minutes} minutes and ${maxBytes} bytes. Use numbers above 0, or 0 to leave one as it is.`,
      );
    }
    const { flightRecorderMs, flightRecorderBytes } = this.#limits.limits;
    if (minutes * MS_PER_MINUTE > flightRecorderMs) {
      throw this.#limits.refusal('flightRecorderMs', `more than ${flightRecorderMs} ms`);
    }
    if (maxBytes > flightRecorderBytes) {
      throw this.#limits.refusal('flightRecorderBytes', `more than ${flightRecorderBytes} bytes`);
    }
    this.#isTold = true;
    this.#settings = { ...wanted, minutes, maxBytes };
    return this.#settings;
  }
}
