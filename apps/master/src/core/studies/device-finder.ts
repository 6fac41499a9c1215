import {
  DATA_FORMATS,
  decodeRecord,
  type Device,
  ComponentIOType,
  type StudyDevice,
} from '@ubii/proto';
import { compileGlob } from '@ubii/patterns';
import type { Client } from '../clients/client.ts';
import type { TopicTable } from '../topics/topic-table.ts';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { DeviceRegistry } from '../devices/device-registry.ts';
import { dataFormatOf, type TopicEntry } from '../topics/topic-entry.ts';
import type { DeviceFacts } from './check-row.ts';
import type { RateMeter } from './rate-meter.ts';

/** Name of the component that publishes the charge of a device. */
const COMPONENT = 'battery';
/** Longest page state. [EX-56] */
const MAX_BYTES = 4_096;

/**
 * Charge of a device, 0 to 1: of its own component, else of that of another device of the client, else of the state that a page
 * publishes. [ST-30] @returns undefined when none is known
 */
function batteryOf(
  topics: TopicTable,
  client: Client,
  device: Device | undefined,
): number | undefined {
  const devices = [...(device === undefined ? [] : [device]), ...client.devices.values()];
  for (const { components } of devices) {
    const topic = components.find(({ name }) => name === COMPONENT)?.topic ?? '';
    const level = levelOf(valueOf(topics, topic, DATA_FORMATS.double.fieldNumber));
    if (level !== undefined) return level;
  }
  const state = valueOf(topics, `/${client.id}/page_state`, DATA_FORMATS.string.fieldNumber);
  return typeof state === 'string' ? levelOf(batteryOfPage(state)) : undefined;
}

function valueOf(topics: TopicTable, topic: string, field: number): unknown {
  const entry = topics.get(topic);
  if (entry?.record === undefined || entry.valueField !== field) return undefined;
  if (entry.record.byteLength > MAX_BYTES) return undefined;
  const { value } = decodeRecord(entry.record);
  return value;
}

function batteryOfPage(text: string): unknown {
  try {
    const state: unknown = JSON.parse(text);
    return typeof state === 'object' && state !== null && 'battery' in state
      ? state.battery
      : undefined;
  } catch {
    return undefined;
  }
}

function levelOf(value: unknown): number | undefined {
  return typeof value === 'number' && value >= 0 && value <= 1 ? value : undefined;
}

/** Shortest and longest time over which rates are measured, milliseconds. */
const MIN_SPAN_MS = 1_000;
const MAX_SPAN_MS = 10_000;
/** Records that a low rate is measured by. */
const MEASURED_RECORDS = 2;

/** What devices are looked for in. */
interface FinderContext {
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
