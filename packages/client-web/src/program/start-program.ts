import { shutDownOnRequest } from '@ubii/program';
import { connectOnce } from '../connect-once.ts';
import type { ClientOptions } from '../core/client/client-options.ts';
import type { UbiiClient } from '../core/client/ubii-client.ts';
import { createClient } from '../create-node-client.ts';
import { resolveEndpoints } from '../endpoints.ts';
import { createIdentityFile, defaultIdentityFile } from './identity-file.ts';
import { endingOf, versionNotice } from './program-ending.ts';

/** The process exits after this time, even if closing has not finished. */
const SHUTDOWN_DEADLINE_MS = 1_900;

/** Options of a program: those of its client, whose master has an address. */
export interface ProgramOptions extends ClientOptions {
  /** Origin of a master, such as `http://localhost:8080`. */
  readonly url: string;
  /** Storage of the identity between runs. @default a file in the home directory, one for each name and master */
  readonly identity?: ClientOptions['identity'];
}

/**
 * Connects a program. Ends the process with one sentence on standard error and a code of `PROGRAM_EXIT_CODES` when the
 * first attempt fails, or later when the client may not connect again; a connection that is lost comes back by itself.
 * Ctrl+C and SIGTERM close the client and end the process.
 * @returns the connected client
 */
export async function startProgram(options: ProgramOptions): Promise<UbiiClient> {
  const { url, name } = options;
  const client = await orEnd(async () => {
    const { origin } = new URL(resolveEndpoints(options, undefined).servicesUrl);
    const identity = createIdentityFile(defaultIdentityFile('programs', origin, name));
    const created = createClient({ identity, ...options });
    await connectOnce(created);
    return created;
  });
  client.onState((state) => {
    if (state.status === 'closed' && state.error !== undefined) end(state.error);
  });
  shutDownOnRequest({
    close: () => client.close(),
    deadlineMs: SHUTDOWN_DEADLINE_MS,
    onError: (error) => write(`Closing failed: ${String(error)}`),
  });
  const { state } = client;
  const notice = state.status === 'connected' ? versionNotice(state.masterVersion, url) : undefined;
  if (notice !== undefined) write(notice);
  return client;
}

async function orEnd<T>(work: () => Promise<T>): Promise<T> {
  try {
    return await work();
  } catch (error) {
    return end(error);
  }
}

/** @throws the error when it is none of options or connection */
function end(error: unknown): never {
  const ending = endingOf(error);
  if (ending === undefined) throw error;
  write(ending.message);
  process.exit(ending.exitCode);
}

function write(line: string): void {
  process.stderr.write(`${line}\n`);
}
