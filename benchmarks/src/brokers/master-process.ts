import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { decode, encode, type Init, type ServiceReply, type ServiceRequest } from '@ubii/proto';
import { startBrokerProcess } from './broker-process.ts';

/** The master as `npm run build` leaves it. */
export const BUILT_MASTER = fileURLToPath(
  new URL('../../../apps/master/dist/main.js', import.meta.url),
);

/** A running master with a data directory of its own. */
export interface MasterProcess {
  readonly pid: number;
  /** Origin, for clients. */
  readonly url: string;
  /** Address of its socket for topic data. */
  readonly topicData: string;
  /** @throws Error with the service's sentence when the reply is an error */
  call(request: Init<ServiceRequest>): Promise<ServiceReply>;
  stop(): Promise<void>;
}

export interface MasterStart {
  /** Main file. */
  readonly master: string;
  readonly profileDir: string | undefined;
  /** Folder with modules to trust. */
  readonly modulesDir?: string;
  /** Of the profile. Default: ubii */
  readonly name?: string;
  /** More flags. */
  readonly flags?: readonly string[];
}

/** Starts a built master on a free port of this machine alone. */
export async function startMasterProcess(start: MasterStart): Promise<MasterProcess> {
  const { master, profileDir, modulesDir, name = 'ubii', flags: more = [] } = start;
  if (!existsSync(master)) {
    throw new Error(`There is no master at ${master}: run \`npm run build\` first.`);
  }
  const dataDir = await mkdtemp(join(tmpdir(), 'ubii-bench-'));
  const flags = ['--host', '127.0.0.1', '--port', '0', '--legacy-ports', 'off', ...more];
  // Trusted local callers are admins, so that rights checks cost nothing per record. Earlier builds lack the flag.
  if (knowsFlag(master, '--trust-loopback')) flags.push('--trust-loopback');
  if (modulesDir !== undefined) flags.push('--modules', modulesDir);
  const process = await startBrokerProcess({
    name,
    args: [master, ...flags, '--data-dir', dataDir, '--print-endpoints', 'json'],
    profileDir,
  });
  const services = String(process.endpoints['servicesBinary']);
  return {
    pid: process.pid,
    url: String(process.endpoints['url']),
    topicData: String(process.endpoints['topicDataWs']),
    call: (request) => callService(services, request),
    stop: async () => {
      await process.stop();
      await rm(dataDir, { recursive: true, force: true });
    },
  };
}

function knowsFlag(master: string, flag: string): boolean {
  return execFileSync(process.execPath, [master, '--help'], { encoding: 'utf8' }).includes(flag);
}

async function callService(url: string, request: Init<ServiceRequest>): Promise<ServiceReply> {
  const response = await fetch(url, {
    method: 'POST',
    headers: { 'content-type': 'application/octet-stream' },
    body: Buffer.from(encode('ubii.services.ServiceRequest', request)),
  });
  const reply = decode('ubii.services.ServiceReply', new Uint8Array(await response.arrayBuffer()));
  if (reply.error !== undefined) {
    const { message, details } = reply.error as { message: string; details?: unknown };
    const more = details === undefined ? '' : ` ${JSON.stringify(details)}`;
    throw new Error(`${request.topic} was answered with: ${message}${more}`);
  }
  return reply;
}
