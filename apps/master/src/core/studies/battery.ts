import { DATA_FORMATS, decodeRecord, type Device } from '@ubii/proto';
import type { Client } from '../clients/client.ts';
import type { TopicTable } from '../topics/topic-table.ts';

/** Name of the component that publishes the charge of a device. */
const COMPONENT = 'battery';
/** Longest page state. [EX-56] */
const MAX_BYTES = 4_096;

/**
 * Charge of a device, 0 to 1: of its own component, else of that of another device of the client, else of the state that a page
 * publishes. [ST-30] @returns undefined when none is known
 */
export function batteryOf(
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
