import { request } from 'node:http';
import type { IncomingHttpHeaders } from 'node:http';
import { join } from 'node:path';
import { readOptions } from '@ubii/program';
import { temporaryFolder } from '@ubii/program/testing';
import { onTestFinished } from 'vitest';

import { createConfig, MASTER_PROGRAM } from '../../src/adapters/config/config.ts';
import type { KnownModel } from '../../src/adapters/models/catalogue.ts';
import { StreamLog } from '../../src/adapters/log/stream-log.ts';
import type { ListeningPorts } from '../../src/adapters/network/listeners.ts';
import { LogTail, type TerminalAccess } from '../../src/index.ts';
import type { RunningMasterContext } from '../../src/running-master.ts';
import { startMaster } from '../../src/start-master.ts';

/** A master with all its adapters on free ports of loopback, closed when the test ends. */
export interface EdgeMaster {
  readonly port: number;
  readonly url: string;
  /** Recorder of the terminal's output. */
  readonly terminal: TerminalAccess;
  /** Lines of the log. */
  readonly logged: readonly string[];
  readonly ports: ListeningPorts;
  close(): Promise<void>;
}

export interface EdgeMasterOptions extends Pick<RunningMasterContext, 'clock' | 'keepAliveMs'> {
  /** More flags. Callers of this machine are admins, unless one of them says otherwise. */
  readonly flags?: readonly string[];
  readonly frontendFolder?: string;
  readonly sdkFolder?: string;
  readonly assetsFolder?: string;
  readonly dataDir?: string;
  /** Models that admins can download. */
  readonly models?: readonly KnownModel[];
  /** The built worker of modules; without it none runs. */
  readonly workerFile?: URL;
  /** The built thread that decodes large requests; without it the main thread does. */
  readonly decodeWorkerFile?: URL;
  /** The built thread that records; without it the main thread does. */
  readonly recorderWorkerFile?: URL;
  /** The built process that checks files for it. */
  readonly checkProcessFile?: URL;
  /** The built thread that reads recordings to be played; without it the main thread does. */
  readonly replayWorkerFile?: URL;
}

export async function startEdgeMaster(options: EdgeMasterOptions = {}): Promise<EdgeMaster> {
  const logged: string[] = [];
  const written = new StreamLog({
    level: 'debug',
    format: 'json',
    write: (line) => logged.push(line),
    nowMs: Date.now,
  });
  const log = new LogTail(written, Date.now, true);
  const dataDir = options.dataDir ?? temporaryFolder();
  const flags = [
    ...['--lan', 'off', '--port', '0', '--data-dir', dataDir],
    ...['--legacy-ports', 'off', '--mdns', 'off', '--trust-loopback'],
  ];
  const master = await startMaster({
    config: createConfig(
      readOptions(MASTER_PROGRAM, [...flags, ...(options.flags ?? [])], {}, '/'),
    ),
    log,
    ...(options.clock && { clock: options.clock }),
    ...(options.keepAliveMs && { keepAliveMs: options.keepAliveMs }),
    version: '1.2.3',
    frontendFolder: options.frontendFolder ?? join(temporaryFolder(), 'not-there'),
    sdkFolder: options.sdkFolder ?? join(temporaryFolder(), 'not-there'),
    assetsFolders: [options.assetsFolder ?? join(temporaryFolder(), 'not-there')],
    workerFile: options.workerFile ?? new URL('not-built.js', import.meta.url),
    ...(options.models && { models: options.models }),
    decodeWorkerFile: options.decodeWorkerFile,
    recorderWorkerFile: options.recorderWorkerFile,
    checkProcessFile: options.checkProcessFile,
    replayWorkerFile: options.replayWorkerFile,
  });
  onTestFinished(() => master.close());
  return {
    port: master.ports.main,
    url: `http://127.0.0.1:${master.ports.main}`,
    terminal: master.terminal!,
    logged,
    ports: master.ports,
    close: () => master.close(),
  };
}

export interface PlainResponse {
  readonly status: number;
  readonly headers: IncomingHttpHeaders;
  readonly body: Buffer;
}

/** A request with exactly the given headers: `fetch` forbids some and adds others. */
export function send(
  port: number,
  path: string,
  { method = 'GET', headers = {}, body }: SendOptions = {},
): Promise<PlainResponse> {
  return new Promise((resolve, reject) => {
    const outgoing = request({ host: '127.0.0.1', port, path, method, headers }, (response) => {
      const chunks: Buffer[] = [];
      response.on('data', (chunk: Buffer) => chunks.push(chunk));
      response.on('error', reject);
      response.on('end', () =>
        resolve({
          status: response.statusCode ?? 0,
          headers: response.headers,
          body: Buffer.concat(chunks),
        }),
      );
    });
    outgoing.on('error', reject);
    outgoing.end(body);
  });
}

export interface SendOptions {
  readonly method?: string;
  readonly headers?: Readonly<Record<string, string>>;
  readonly body?: string | Uint8Array;
}
