import { RunningProgram, temporaryFolder } from '@ubii/program/testing';
import { masterProgram, nodeProgram } from './build-programs.ts';

export { recordingsProgram } from './build-programs.ts';

/** Starts a master. @param port 0 for any free one */
export async function startMaster(
  port = 0,
  dataDir = temporaryFolder(),
  flags: readonly string[] = ['--trust-loopback'],
) {
  const program = new RunningProgram(masterProgram, [
    ...['--lan', 'off', '--port', String(port), '--legacy-ports', 'off', '--data-dir', dataDir],
    ...['--print-endpoints', 'json', ...flags],
  ]);
  const { url } = await program.ready<{ url: string }>();
  return { program, url, port: Number(new URL(url).port), dataDir };
}

/** Starts a node. */
export function startNode(
  flags: readonly string[],
  options?: { withChannel?: boolean },
): RunningProgram {
  return new RunningProgram(nodeProgram, flags, options);
}
