import { GAMES } from '../games.ts';
import type { GameSettings } from '../game.ts';
import type { Room } from './room.ts';
import { RoomRefusal } from './room-event.ts';

/** The greatest setting that modules accept. */
const MAX_SETTING = 5;

/** Changes a setting of a game. Values as the game is meant are not kept. */
export function setSetting(room: Room, game: string, setting: string, value: number): Room {
  const meant = Object.hasOwn(GAMES, game)
    ? (GAMES[game as keyof typeof GAMES].settings as GameSettings)
    : {};
  if (!Object.hasOwn(meant, setting) || !Number.isFinite(value))
    throw new RoomRefusal('This game does not have this setting.');
  const { [game]: before = {}, ...others } = room.settings;
  const { [setting]: _, ...rest } = before;
  const kept = Math.min(MAX_SETTING, Math.max(0, value));
  const changed = kept === meant[setting] ? rest : { ...rest, [setting]: kept };
  const isAsMeant = Object.keys(changed).length === 0;
  return { ...room, settings: isAsMeant ? others : { ...others, [game]: changed } };
}
