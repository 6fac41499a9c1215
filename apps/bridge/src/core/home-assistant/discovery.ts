import { literalPath } from '../mapping/literal-path.ts';
import { OTHER_PROTOCOLS } from '../mapping/mapping.ts';
import type { Mapping } from '../mapping/mapping.ts';
import type { OutgoingMessage } from '../ports/foreign-system.ts';
import { NODE_PREFIX } from './entities.ts';
import type { Entities, Entity } from './entities.ts';

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

  /** Another bridge announces the devices from now on. What it says of them takes the place of what this one has said. */
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
  ...{ format: undefined, payload: 'json', field: [], ...OTHER_PROTOCOLS },
  ...{ qos: 1, retained: true, maxRateHz: 0, maxTopics: 1, maxBytes: 64 * 1024 },
};
