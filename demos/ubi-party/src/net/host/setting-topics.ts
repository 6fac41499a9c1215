import type { UbiiClient } from '@ubii/client-web';
import { GAMES, type Room } from '../../sim/index.ts';
import { settingTopic } from '../topics.ts';

/** Tells modules the settings that are not as their game is meant: a master that was restarted does not know them. */
export function publishSettings(client: UbiiClient, { settings }: Room): void {
  for (const [game, values] of Object.entries(settings)) {
    for (const [name, value] of Object.entries(values))
      client.publish(settingTopic(game, name), 'double', value);
  }
}

/** The topics of all settings: one that was changed back has a value, too. */
export function settingTopics(): string[] {
  return Object.values(GAMES).flatMap(({ id, settings }) =>
    Object.keys(settings).map((name) => settingTopic(id, name)),
  );
}
