import type { UbiiClient } from '@ubii/client-web';
import type { Room } from '../../sim/index.ts';
import { settingTopic } from '../topics.ts';

/** Tells modules the settings that are not as their game is meant: a master that was restarted does not know them. */
export function publishSettings(client: UbiiClient, { settings }: Room): void {
  for (const [game, values] of Object.entries(settings)) {
    for (const [name, value] of Object.entries(values))
      client.publish(settingTopic(game, name), 'double', value);
  }
}

/** The topics of settings that are not as their game is meant. */
export function settingTopicsOf({ settings }: Room): string[] {
  return Object.entries(settings).flatMap(([game, values]) =>
    Object.keys(values).map((name) => settingTopic(game, name)),
  );
}
