import { ComponentIOType, parseDataFormat } from '@ubii/proto';
import type { Component, DataFormat, Device } from '@ubii/proto';
import { BRIDGE_LIMITS } from '../limits.ts';
import { literalPath } from '../mapping/literal-path.ts';
import { OTHER_PROTOCOLS } from '../mapping/mapping.ts';
import type { Mapping, PayloadKind } from '../mapping/mapping.ts';
import type { HomeAssistantSettings } from '../mapping/read-mapping-file.ts';
import { BUTTON_EVENTS, BUTTON_FORMATS } from '../payload/button-events.ts';

/** Announcement of a component of a device for Home Assistant. */
export interface Entity {
  /** Where its discovery message goes. */
  readonly configTopic: string;
  /** Content of the discovery message. */
  readonly config: Readonly<Record<string, unknown>>;
  readonly mapping: Mapping;
}

/** Entities of all devices, and how many components have none. */
export interface Entities {
  readonly entities: readonly Entity[];
  readonly skipped: number;
}

/** Where entities come from. */
export interface EntityContext {
  readonly settings: HomeAssistantSettings;
  /** Topic at which the bridge says whether it is there. */
  readonly availability: string;
  /** The client of the bridge, whose devices are none of Home Assistant. */
  readonly ownId: string;
}

const MAX_ENTITIES = 500;
/** Our own among the nodes of the discovery. */
export const NODE_PREFIX = 'ubii_';

const NUMBERS: readonly DataFormat[] = ['double', 'float', 'int32'];

/** Component of Home Assistant, with what it needs besides, for a component of ours. */
interface Kind {
  readonly component: string;
  readonly payload: PayloadKind;
  readonly extra: Readonly<Record<string, unknown>>;
}

/** [BR-50] */
function kindOf(format: DataFormat | undefined, isSubscriber: boolean): Kind | undefined {
  if (format === undefined) return undefined;
  const onOff = { payload_on: 'true', payload_off: 'false' };
  if (NUMBERS.includes(format)) {
    const step = format === 'int32' ? 1 : 0.001;
    const range = { min: -1_000_000, max: 1_000_000, step, mode: 'box' };
    return isSubscriber
      ? { component: 'number', payload: 'text', extra: range }
      : { component: 'sensor', payload: 'text', extra: { state_class: 'measurement' } };
  }
  if (format === 'bool') {
    const switched = { ...onOff, state_on: 'true', state_off: 'false', optimistic: true };
    return isSubscriber
      ? { component: 'switch', payload: 'text', extra: switched }
      : { component: 'binary_sensor', payload: 'text', extra: onOff };
  }
  if (format === 'string') {
    return isSubscriber
      ? { component: 'text', payload: 'text', extra: {} }
      : { component: 'sensor', payload: 'text', extra: {} };
  }
  if (BUTTON_FORMATS.includes(format) && !isSubscriber) {
    return { component: 'event', payload: 'event', extra: { event_types: [...BUTTON_EVENTS] } };
  }
  return undefined;
}

/** Returns the announcements of the devices of a master for Home Assistant. */
export function entitiesOf(devices: readonly Device[], context: EntityContext): Entities {
  const entities: Entity[] = [];
  let skipped = 0;
  for (const device of devices.filter(({ clientId }) => clientId !== context.ownId)) {
    const seen = new Set<string>();
    for (const component of device.components) {
      const entity =
        entities.length < MAX_ENTITIES ? entityOf(device, component, context) : undefined;
      if (entity === undefined || seen.has(entity.configTopic)) skipped++;
      else entities.push(entity);
      if (entity !== undefined) seen.add(entity.configTopic);
    }
  }
  return { entities, skipped };
}

function entityOf(
  device: Device,
  component: Component,
  context: EntityContext,
): Entity | undefined {
  const isSubscriber = component.ioType === ComponentIOType.SUBSCRIBER;
  const format = parseDataFormat(component.messageFormat);
  const kind = kindOf(format, isSubscriber);
  if (kind === undefined || component.topic === '') return undefined;
  const { prefix, topics } = context.settings;
  const node = `${NODE_PREFIX}${identifier(device.id)}`;
  const object = identifier(component.name || component.id || component.topic);
  const topic = `${topics}/${identifier(device.id)}/${object}`;
  const stateTopic = isSubscriber ? { command_topic: `${topic}/set` } : { state_topic: topic };
  return {
    configTopic: `${prefix}/${kind.component}/${node}/${object}/config`,
    config: {
      name: component.name || component.topic,
      unique_id: `${node}_${object}`,
      ...stateTopic,
      ...kind.extra,
      availability_topic: context.availability,
      device: {
        identifiers: [node],
        name: device.name || 'Device',
        manufacturer: 'Ubi-Interact',
        ...(device.description !== '' && { model: device.description.slice(0, 100) }),
      },
      origin: { name: 'Ubi-Interact' },
    },
    mapping: {
      name: `Home Assistant: ${node}/${object}`,
      direction: isSubscriber ? 'in' : 'out',
      foreign: literalPath(isSubscriber ? `${topic}/set` : topic),
      topic: literalPath(component.topic),
      format,
      payload: kind.payload,
      field: [],
      ...OTHER_PROTOCOLS,
      // The newest state is there for a Home Assistant that starts later; commands and events are of their moment.
      retained: !isSubscriber && kind.payload !== 'event',
      // An event that waited would come too late.
      qos: kind.payload === 'event' ? 0 : 1,
      maxRateHz: kind.payload === 'event' ? 0 : 5,
      maxTopics: 1,
      maxBytes: Math.min(64 * 1024, BRIDGE_LIMITS.messageBytes),
    },
  };
}

/** Ids of the discovery have letters, digits, `_` and `-` only. */
function identifier(text: string): string {
  return text.replace(/[^A-Za-z0-9_-]+/g, '_').slice(0, 64) || '_';
}
