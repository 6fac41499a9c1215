import { createHash } from 'node:crypto';
import type { UbiiClient } from '@ubii/client-web/node';
import { within } from '@ubii/timing';
import type { Clock } from '@ubii/timing';
import { announceMappings, watchBridges } from './adapters/master/watch-bridges.ts';
import type { OtherBridges } from './core/loop/other-bridges.ts';
import type { MappingFile } from './core/mapping/read-mapping-file.ts';

/** A master that announces no clients has no other bridges either, and one of an earlier version says nothing of its mappings. */
const BRIDGES_TIMEOUT_MS = 3_000;

/** Arguments of `createStandBy`. */
export interface StandByContext {
  readonly client: UbiiClient;
  readonly bridges: OtherBridges;
  readonly clock: Pick<Clock, 'after'>;
  /** The file as it is now. */
  file(): MappingFile;
  /** This bridge passes its mappings from now on, or another one does. */
  onChange(isActive: boolean): void;
}

/** Whether this bridge passes its mappings, or stands by for another one that has the same. [BR-24] */
export interface StandBy {
  readonly isActive: boolean;
  /** Resolves when the other bridges are known. */
  handleConnected(): Promise<void>;
  handleLost(): void;
  /** The mappings have changed. */
  update(): void;
}

/** @see StandBy */
export function createStandBy({ client, bridges, clock, file, onChange }: StandByContext): StandBy {
  /** `undefined`: not decided yet. */
  let isActive: boolean | undefined;
  let isKnown = false;
  let watching: Promise<void> | undefined;
  const decide = (): void => {
    const next = !bridges.passesFor(client.id, fingerprintOf(file()));
    if (!isKnown || next === isActive) return;
    isActive = next;
    onChange(next);
  };
  bridges.onChange(decide);
  return {
    get isActive() {
      return isActive === true;
    },
    async handleConnected() {
      announceMappings(client, fingerprintOf(file()));
      watching ??= watchBridges(client, bridges);
      await watching;
      await within(clock, BRIDGES_TIMEOUT_MS, bridges.untilKnown(client.id));
      isKnown = true;
      decide();
    },
    handleLost() {
      isKnown = false;
      bridges.handleLost();
    },
    update() {
      if (client.state.status === 'connected') announceMappings(client, fingerprintOf(file()));
      decide();
    },
  };
}

function fingerprintOf({ mappings, homeAssistant }: MappingFile): string {
  const text = JSON.stringify([mappings, homeAssistant]);
  return createHash('sha256').update(text).digest('hex').slice(0, 32);
}
