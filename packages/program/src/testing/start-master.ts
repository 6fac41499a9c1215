import { RunningProgram } from './running-program.ts';
import { temporaryFolder } from './temporary-folder.ts';

/** A master that was started. */
export interface StartedMaster {
  readonly program: RunningProgram;
  readonly url: string;
  readonly port: number;
  readonly dataDir: string;
}

/** How a master is started: its port (0 for any free one), data directory and further flags. */
export type MasterArgs = [port?: number, dataDir?: string, flags?: readonly string[]];

/**
 * Starts a master and resolves when it listens. By default, clients of this machine are admins.
 *
 * @param file the program
 */
export async function startMaster(
  file: string,
  ...[port = 0, dataDir = temporaryFolder(), flags = ['--trust-loopback']]: MasterArgs
): Promise<StartedMaster> {
  const program = new RunningProgram(file, [
    ...['--lan', 'off', '--port', String(port), '--legacy-ports', 'off', '--data-dir', dataDir],
    ...['--print-endpoints', 'json', ...flags],
  ]);
  const { url } = await program.ready<{ url: string }>();
  return { program, url, port: Number(new URL(url).port), dataDir };
}
