import { compileGlob } from '@ubii/patterns';
import { ComponentIOType, type Device, type StudyDevice } from '@ubii/proto';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { Client } from '../clients/client.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import { dataFormatOf, type TopicEntry } from '../topics/topic-entry.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import { batteryOf } from './battery.ts';
import type { DeviceFacts } from './check-row.ts';
import type { RateMeter } from './rate-meter.ts';

/** Shortest and longest time over which rates are measured, milliseconds. */
const MIN_SPAN_MS = 1_000;
const MAX_SPAN_MS = 10_000;
/** Records that a low rate is measured by. */
const MEASURED_RECORDS = 2;

/** What devices are looked for in. */
export interface FinderContext {
  readonly topics: TopicTable;
  readonly devices: DeviceRegistry;
  readonly clients: ClientRegistry;
  /** Id of the master as a publisher. */
  readonly masterId: string;
  readonly masterName: string;
  readonly rates: RateMeter;
}

/** Something that fits a required device: a device, or a publisher whose topics belong to no device. */
interface Source {
  /** Undefined: modules of the master itself. */
  readonly client: Client | undefined;
  readonly device: Device | undefined;
  readonly topics: TopicEntry[];
}

/** Finds what fits a required device, and what the master knows of it. [ST-30] */
export class DeviceFinder {
  readonly #context: FinderContext;

  constructor(context: FinderContext) {
    this.#context = context;
  }

  find(required: StudyDevice): DeviceFacts[] {
    const sources = required.tag === '' ? this.#byTopic(required) : this.#byTag(required.tag);
    return sources.map((source) => this.#factsOf(source, required.minRateHz));
  }

  #byTag(tag: string): Source[] {
    const { devices, clients, topics } = this.#context;
    return devices.list().flatMap((device) => {
      const client = clients.get(device.clientId);
      if (client?.status !== 'active') return [];
      const isTagged = device.tags.includes(tag);
      const components = isTagged
        ? device.components
        : device.components.filter(({ tags }) => tags.includes(tag));
      if (!isTagged && components.length === 0) return [];
      const entries = components
        .filter(({ ioType }) => ioType !== ComponentIOType.SUBSCRIBER)
        .flatMap(({ topic }) => topics.get(topic) ?? []);
      return [{ client, device, topics: entries }];
    });
  }

  #byTopic({ topicPattern, dataFormat }: StudyDevice): Source[] {
    const isInPattern = compileGlob(topicPattern);
    const sources = new Map<string, Source>();
    for (const entry of this.#context.topics.values()) {
      if (entry.isMasters || entry.record === undefined) continue;
      const fits =
        dataFormat === '' ? isInPattern(entry.topic) : dataFormatOf(entry) === dataFormat;
      if (!fits) continue;
      const source = this.#sourceOf(entry);
      if (source === undefined) continue;
      const key = source.device?.id ?? entry.publisherId;
      const known = sources.get(key);
      if (known === undefined) sources.set(key, source);
      else known.topics.push(entry);
    }
    return [...sources.values()];
  }

  /** Undefined when its publisher is not connected. */
  #sourceOf(entry: TopicEntry): Source | undefined {
    const { clients, devices, masterId } = this.#context;
    const { publisherId, topic } = entry;
    const client = clients.get(publisherId);
    if (publisherId !== masterId && client?.status !== 'active') return undefined;
    const device = devices
      .publishersOf(topic)
      .map(({ deviceId }) => devices.get(deviceId))
      .find((each) => each?.clientId === publisherId);
    return { client, device, topics: [entry] };
  }

  #factsOf({ client, device, topics }: Source, minRateHz: number): DeviceFacts {
    const { masterName } = this.#context;
    const label = client?.label ?? masterName;
    const name = device === undefined || device.name === '' ? label : `${label}: ${device.name}`;
    return {
      name,
      rateHz: this.#rateOf(topics, minRateHz),
      battery: client && batteryOf(this.#context.topics, client, device),
      clockErrorMs: clockErrorOf(client),
    };
  }

  /** Of the fastest topic; low rates are measured for longer. */
  #rateOf(topics: readonly TopicEntry[], minRateHz: number): number | undefined {
    const { rates } = this.#context;
    const spanMs = (MEASURED_RECORDS * 1_000) / (minRateHz || 1);
    const boundMs = Math.min(Math.max(spanMs, MIN_SPAN_MS), MAX_SPAN_MS);
    if (!rates.isReady) return undefined;
    return Math.max(0, ...topics.map((entry) => rates.rateOf(entry, boundMs) ?? 0));
  }
}

/** Programs on the master's machine have its clock. */
function clockErrorOf(client: Client | undefined): number | undefined {
  if (client === undefined) return 0;
  return client.clock?.errorMs ?? (client.peer.addressKind === 'loopback' ? 0 : undefined);
}
