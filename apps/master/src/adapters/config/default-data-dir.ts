import { homedir } from 'node:os';
import { join } from 'node:path';

/**
 * The folder where programs of this system keep data of a user: it outlives a new clone of the
 * repository and does not depend on where the master was started.
 */
export function defaultDataDir(
  env: Readonly<Record<string, string | undefined>> = process.env,
  platform: string = process.platform,
  home: string = homedir(),
): string {
  switch (platform) {
    case 'darwin':
      return join(home, 'Library', 'Application Support', 'ubi-interact');
    case 'win32':
      return join(env['LOCALAPPDATA'] ?? join(home, 'AppData', 'Local'), 'ubi-interact');
    default:
      // XDG Base Directory Specification: an unset or empty variable means ~/.local/share.
      return join(env['XDG_DATA_HOME'] || join(home, '.local', 'share'), 'ubi-interact');
  }
}
