import type { Device } from '@ubii/proto';
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
}

/** Devices of the master, as Home Assistant finds them at a broker. [BR-50] */
export class HomeAssistant {
  readonly #world: HomeAssistantWorld;
  readonly #discovery: Discovery;
  readonly #found: Mapping;
  #entities: Entities = { entities: [], skipped: 0 };

  constructor(world: HomeAssistantWorld) {
    this.#world = world;
    const { settings, availability } = world;
    this.#discovery = new Discovery({ prefix: settings.prefix, availability }, (message) =>
      world.send(message),
    );
    this.#found = {
      ...{ name: 'Home Assistant: earlier run', direction: 'in' },
      ...parseSides(this.#discovery.filter, '/', 'in'),
      ...{
        format: undefined,
        payload: 'bytes',
        field: [],
        qos: 1,
        retained: true,
        ...OTHER_PROTOCOLS,
      },
      ...{ maxRateHz: 0, maxTopics: 1, maxBytes: 64 * 1024 },
    };
  }

  /** Mappings of the components. */
  get mappings(): readonly Mapping[] {
    return this.#entities.entities.map(({ mapping }) => mapping);
  }

  /** What the broker is asked for besides. */
  get subscription(): Mapping {
    return this.#found;
  }

  get counts(): { readonly entities: number; readonly skipped: number } {
    return { entities: this.#entities.entities.length, skipped: this.#entities.skipped };
  }

  handleDevices(devices: readonly Device[]): void {
    const { settings, availability } = this.#world;
    this.#entities = entitiesOf(devices, { settings, availability, ownId: this.#world.ownId() });
    this.#discovery.update(this.#entities);
    this.#world.onChange();
  }

  /** @returns whether it was a message of the discovery */
  handleMessage({ address, payload }: ForeignMessage<Uint8Array>): boolean {
    const { prefix } = this.#world.settings;
    if (!address.startsWith(`${prefix}/`) || !address.endsWith('/config')) return false;
    this.#discovery.handleFound(address, payload);
    return true;
  }

  /** Removes what was announced. */
  close(): void {
    this.#discovery.removeAll();
  }
}
