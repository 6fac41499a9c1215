import {
  ServiceError,
  type FlightRecorder,
  type FlightRecorderSettings,
  type Recording,
} from '@ubii/proto';
import type { RecordingEvent } from '@ubii/recording';
import type { Recorder, RecordingJob } from '@ubii/recording/recorder';
import type { LimitWatch } from '../counters/limit-watch.ts';
import { FlightSettings } from './flight-settings.ts';
import type { RecordCollector } from './record-collector.ts';

/** What they work with. */
export interface FlightOrdersContext {
  readonly limits: LimitWatch;
  readonly recorder: Recorder;
  readonly collector: RecordCollector;
  readonly flight: FlightRecorderSettings;
  /** Clients, devices and sessions as they are. */
  readonly present: () => readonly RecordingEvent[];
}

/** What the master asks of the flight recorder, which knows nothing before the first record: it takes no memory till then. */
export class FlightOrders {
  readonly #context: FlightOrdersContext;
  readonly #settings: FlightSettings;

  constructor(context: FlightOrdersContext) {
    this.#context = context;
    const { collector, flight, limits } = context;
    this.#settings = new FlightSettings(flight, limits);
    collector.onFirstOfFlight.add(() => this.sendOrders());
    collector.setFlight(flight.isOn, flight.withImages);
  }

  get settings(): FlightRecorderSettings {
    return this.#settings.settings;
  }

  describe(): Promise<FlightRecorder> {
    this.sendOrders();
    return this.#context.recorder.flight();
  }

  /** [RC-31] */
  change(wanted: FlightRecorderSettings): Promise<FlightRecorder> {
    const { collector, recorder, present } = this.#context;
    const settings = this.#settings.change(wanted);
    collector.setFlight(settings.isOn, settings.withImages);
    return recorder.setFlight({ ...settings, present: present() });
  }

  /** Drops its records, and continues. [RC-34] */
  async empty(): Promise<void> {
    const { settings } = this;
    if (!settings.isOn) return;
    const { collector, recorder, present } = this.#context;
    collector.flush();
    this.#settings.takeUntold();
    const emptied = recorder.setFlight({ ...settings, isOn: false, present: [] });
    await Promise.all([emptied, recorder.setFlight({ ...settings, present: present() })]);
  }

  /** [RC-32] @throws ServiceError when it is off */
  requireOn(): void {
    if (this.settings.isOn) return;
    throw new ServiceError(
      'failed_precondition',
      'The flight recorder is off, so there is nothing to keep. Turn it on first.',
    );
  }

  keep(job: RecordingJob): Promise<Recording> {
    this.#context.collector.flush();
    this.sendOrders();
    return this.#context.recorder.keep(job);
  }

  /** Tells the recorder to keep the last minutes, unless it knows. [RC-30] */
  sendOrders(): void {
    const settings = this.#settings.takeUntold();
    if (settings === undefined) return;
    const { recorder, present } = this.#context;
    void recorder.setFlight({ ...settings, present: present() }).catch(() => undefined);
  }
}
