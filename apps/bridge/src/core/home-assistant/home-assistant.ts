import type { Device } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { Sampler } from '../engine/sampler.ts';
import { parseSides } from '../mapping/address-path.ts';
import { OTHER_PROTOCOLS } from '../mapping/mapping.ts';
import type { Mapping } from '../mapping/mapping.ts';
import type { HomeAssistantSettings } from '../mapping/read-mapping-file.ts';
import type { ForeignMessage, OutgoingMessage } from '../ports/foreign-system.ts';
import { Discovery } from './discovery.ts';
import { entitiesOf } from './entities.ts';
import type { Entities } from './entities.ts';

/** What `HomeAssistant` needs. */
export interface HomeAssistantWorld {
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
  readonly #world: HomeAssistantWorld;
  readonly #discovery: Discovery;
  readonly #subscriptions: readonly Mapping[];
  readonly #repeats: Sampler;
  #devices: readonly Device[] | undefined;
  #isActive = true;
  #entities: Entities = { entities: [], skipped: 0 };

  constructor(world: HomeAssistantWorld) {
    this.#world = world;
    const { settings, availability } = world;
    this.#discovery = new Discovery({ prefix: settings.prefix, availability }, (message) =>
      world.send(message),
    );
    this.#repeats = new Sampler({
      clock: world.clock,
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
    this.#world.onChange();
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
    const { prefix } = this.#world.settings;
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
    const { settings, availability } = this.#world;
    const ownId = this.#world.ownId();
    this.#entities = entitiesOf(this.#devices, { settings, availability, ownId });
    this.#discovery.update(this.#entities);
  }
}

/** What the broker is asked for, and no topic gets. */
function listening(name: string, filter: string, retained: boolean): Mapping {
  return {
    ...{ name, direction: 'in', ...parseSides(filter, '/', 'in') },
    ...{ format: undefined, payload: 'bytes', field: [], ...OTHER_PROTOCOLS },
    ...{ qos: 1, retained, maxRateHz: 0, maxTopics: 1, maxBytes: 64 * 1024 },
  };
}
