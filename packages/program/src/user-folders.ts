import { homedir } from 'node:os';
import { join } from 'node:path';
import type { Environment } from './read-options.ts';

const NAME = 'ubi-interact';

/** Returns the folder for data that a user keeps, as the system has it for its programs. */
export function userDataFolder(
  env: Environment = process.env,
  platform: string = process.platform,
  home: string = homedir(),
): string {
  switch (platform) {
    case 'darwin':
      return join(home, 'Library', 'Application Support', NAME);
    case 'win32':
      return join(env['LOCALAPPDATA'] ?? join(home, 'AppData', 'Local'), NAME);
    default:
      // XDG Base Directory Specification: an unset or empty variable means ~/.local/share.
      return join(env['XDG_DATA_HOME'] || join(home, '.local', 'share'), NAME);
  }
}

/** Returns the folder for state that outlives a run of a program, and is of use on this machine only. */
export function userStateFolder(env: Environment = process.env, home: string = homedir()): string {
  // XDG Base Directory Specification; an unset or empty variable means ~/.local/state.
  return join(env['XDG_STATE_HOME'] || join(home, '.local', 'state'), NAME);
}
