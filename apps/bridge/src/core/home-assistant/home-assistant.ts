import type { Device } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { literalPath } from '../mapping/literal-path.ts';
import { OTHER_PROTOCOLS, type Mapping } from '../mapping/mapping.ts';
import type { OutgoingMessage, ForeignMessage } from '../ports/foreign-system.ts';
import { NODE_PREFIX, type Entities, type Entity, entitiesOf } from './entities.ts';
import { Sampler } from '../engine/sampler.ts';
import { parseSides } from '../mapping/address-path.ts';
import type { HomeAssistantSettings } from '../mapping/read-mapping-file.ts';

const MAX_FOUND = 2_000;

/** Discovery messages at the broker: sends those that are new or have changed, and removes those of devices that are gone. [BR-51] */
export class Discovery {
  readonly #prefix: string;
  readonly #availability: string;
  readonly #send: (message: OutgoingMessage<Uint8Array>) => void;
  /** Text of each discovery message that was sent. */
  readonly #sent = new Map<string, string>();
  /** State topics with a retained value, by discovery topic. */
  readonly #states = new Map<string, string>();
  /** Topics of an earlier run of this bridge, until the devices are known. */
  #found: Set<string> | undefined = new Set();

  /** @param prefix of the discovery, such as `homeassistant` */
  constructor(
    { prefix, availability }: { readonly prefix: string; readonly availability: string },
    send: (message: OutgoingMessage<Uint8Array>) => void,
  ) {
    this.#prefix = prefix;
    this.#availability = availability;
    this.#send = send;
  }

  /** Filter of the discovery messages of an earlier run. */
  get filter(): string {
    return `${this.#prefix}/+/+/+/config`;
  }

  /** A retained discovery message that the broker has. Those of other programs and bridges are left alone. */
  handleFound(topic: string, payload: Uint8Array): void {
    const [, , node = ''] = topic.slice(this.#prefix.length).split('/');
    if (!node.startsWith(NODE_PREFIX) || payload.byteLength === 0 || this.#sent.has(topic)) return;
    let config: { readonly availability_topic?: unknown } | null;
    try {
      config = JSON.parse(new TextDecoder().decode(payload)) as typeof config;
    } catch {
      return;
    }
    if (config?.availability_topic !== this.#availability) return;
    if (this.#found === undefined) this.#remove(topic);
    else if (this.#found.size < MAX_FOUND) this.#found.add(topic);
  }

  /** The devices are these now. */
  update({ entities }: Entities): void {
    const wanted = new Set(entities.map(({ configTopic }) => configTopic));
    const old = new Set([...this.#sent.keys(), ...(this.#found ?? [])]);
    this.#found = undefined;
    for (const topic of old) if (!wanted.has(topic)) this.#remove(topic);
    for (const entity of entities) this.#announce(entity);
  }

  /** Sends all announcements again: the broker may have lost its kept messages. */
  announceAgain(): void {
    for (const [topic, text] of this.#sent) this.#tell(topic, text);
  }

  /** Another bridge announces the devices from now on. Its announcements replace those of this bridge. */
  handOver(): void {
    this.#sent.clear();
    this.#states.clear();
  }

  /** Forgets what was announced: the bridge ends. */
  removeAll(): void {
    for (const topic of [...this.#sent.keys()]) this.#remove(topic);
  }

  #announce({ configTopic, config, mapping }: Entity): void {
    const text = JSON.stringify(config);
    if (this.#sent.get(configTopic) === text) return;
    this.#sent.set(configTopic, text);
    if (mapping.retained) this.#states.set(configTopic, mapping.foreign.text);
    this.#tell(configTopic, text);
  }

  #tell(address: string, text: string): void {
    this.#send({ address, payload: new TextEncoder().encode(text), mapping: CONFIG_MAPPING });
  }

  #remove(topic: string): void {
    this.#sent.delete(topic);
    this.#send({ address: topic, payload: undefined, mapping: CONFIG_MAPPING });
    const state = this.#states.get(topic);
    this.#states.delete(topic);
    if (state === undefined) return;
    this.#send({ address: state, payload: undefined, mapping: CONFIG_MAPPING });
  }
}

/** How discovery messages are sent. */
const CONFIG_MAPPING: Mapping = {
  name: 'Home Assistant: discovery',
  direction: 'out',
  foreign: literalPath(''),
  topic: literalPath(''),
  format: undefined,
  payload: 'json',
  field: [],
  ...OTHER_PROTOCOLS,
  qos: 1,
  retained: true,
  maxRateHz: 0,
  maxTopics: 1,
  maxBytes: 64 * 1024,
};

/** What `HomeAssistant` needs. */
interface HomeAssistantContext {
  readonly settings: HomeAssistantSettings;
  readonly availability: string;
  ownId(): string;
  send(message: OutgoingMessage<Uint8Array>): void;
  /** The mappings have changed. */
  onChange(): void;
  readonly clock: Clock;
}

/** Where Home Assistant says that it is there, and what (its default, whatever the prefix is). */
const BIRTH = { topic: 'homeassistant/status', text: 'online' } as const;
/** All is announced again at most so often. */
const MAX_REPEATS_HZ = 0.2;

/** Devices of the master, as Home Assistant finds them at a broker. [BR-50] */
export class HomeAssistant {
  readonly #context: HomeAssistantContext;
  readonly #discovery: Discovery;
  readonly #subscriptions: readonly Mapping[];
  readonly #repeats: Sampler;
  #devices: readonly Device[] | undefined;
  #isActive = true;
  #entities: Entities = { entities: [], skipped: 0 };

  constructor(context: HomeAssistantContext) {
    this.#context = context;
    const { settings, availability } = context;
    this.#discovery = new Discovery({ prefix: settings.prefix, availability }, (message) =>
      context.send(message),
    );
    this.#repeats = new Sampler({
      clock: context.clock,
      maxRateHz: MAX_REPEATS_HZ,
      maxAddresses: 1,
    });
    this.#subscriptions = [
      listening('Home Assistant: earlier run', this.#discovery.filter, true),
      listening('Home Assistant: birth', BIRTH.topic, false),
    ];
  }

  /** Mappings of the components. */
  get mappings(): readonly Mapping[] {
    return this.#entities.entities.map(({ mapping }) => mapping);
  }

  /** What the broker is asked for besides. */
  get subscriptions(): readonly Mapping[] {
    return this.#isActive ? this.#subscriptions : [];
  }

  get counts(): { readonly entities: number; readonly skipped: number } {
    return { entities: this.#entities.entities.length, skipped: this.#entities.skipped };
  }

  handleDevices(devices: readonly Device[]): void {
    this.#devices = devices;
    this.#update();
    this.#context.onChange();
  }

  /** Whether this bridge announces the devices; otherwise another one does. [BR-22] */
  setActive(isActive: boolean): void {
    if (isActive === this.#isActive) return;
    this.#isActive = isActive;
    if (isActive) return this.#update();
    this.#entities = { entities: [], skipped: 0 };
    this.#discovery.handOver();
  }

  /** The broker, or Home Assistant, may not have the announcements any more. [BR-52] */
  announceAgain(): void {
    this.#repeats.offer('', () => this.#discovery.announceAgain());
  }

  /** @returns whether it was a message of the discovery */
  handleMessage({ address, payload, isKept }: ForeignMessage<Uint8Array>): boolean {
    if (address === BIRTH.topic) {
      // One that was kept says nothing of now.
      const isBirth = new TextDecoder().decode(payload) === BIRTH.text && !isKept;
      if (isBirth) this.announceAgain();
      return isBirth;
    }
    const { prefix } = this.#context.settings;
    if (!address.startsWith(`${prefix}/`) || !address.endsWith('/config')) return false;
    this.#discovery.handleFound(address, payload);
    return true;
  }

  /** Removes what was announced. */
  close(): void {
    this.#repeats.close();
    this.#discovery.removeAll();
  }

  #update(): void {
    if (!this.#isActive || this.#devices === undefined) return;
    const { settings, availability } = this.#context;
    const ownId = this.#context.ownId();
    this.#entities = entitiesOf(this.#devices, { settings, availability, ownId });
    this.#discovery.update(this.#entities);
  }
}

/** What the broker is asked for, and no topic gets. */
function listening(name: string, filter: string, retained: boolean): Mapping {
  return {
    name,
    direction: 'in',
    ...parseSides(filter, '/', 'in'),
    format: undefined,
    payload: 'bytes',
    field: [],
    ...OTHER_PROTOCOLS,
    qos: 1,
    retained,
    maxRateHz: 0,
    maxTopics: 1,
    maxBytes: 64 * 1024,
  };
}
