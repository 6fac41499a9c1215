import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { MasterProcess, StartRefused, type MasterStart } from '@ubii/harness';

import type { Random } from '../../random.ts';
import type { Entrance } from '../entrance.ts';
import { joined, mutateBytes } from '../mutate-bytes.ts';
import { mutateJson } from '../mutate-json.ts';

/** A certificate for `localhost` that no client trusts, and its key: for tests alone. */
const CERTIFICATE_PEM = `-----BEGIN CERTIFICATE-----
MIIBlTCCATugAwIBAgIUIifbZeQyBnD7PITLSWkMvoOuVlswCgYIKoZIzj0EAwIw
FDESMBAGA1UEAwwJbG9jYWxob3N0MCAXDTI2MTEyMjIwMjY0MVoYDzIxMjYxMDI5
MjAyNjQxWjAUMRIwEAYDVQQDDAlsb2NhbGhvc3QwWTATBgcqhkjOPQIBBggqhkjO
PQMBBwNCAAR4KrH4Eb0fAOJFn+vNJGe94KLBVJoFxL3Q8mIUz0dGYSZXKrz7L099
N5/wcZzghJ12aI0/T4uYeNrZs6gBO7f1o2kwZzAdBgNVHQ4EFgQUzvaLJsc9Y+W7
9nXQG5x2TWEW/cIwHwYDVR0jBBgwFoAUzvaLJsc9Y+W79nXQG5x2TWEW/cIwDwYD
VR0TAQH/BAUwAwEB/zAUBgNVHREEDTALgglsb2NhbGhvc3QwCgYIKoZIzj0EAwID
SAAwRQIgfczkhikWrJfa4UEY9RwryZ5yVeCEbbr0vusA37678pwCIQDSjGh1hRx/
pu7JFOoZTAdPLKzSnUej0SFFhpEXN3S8LQ==
-----END CERTIFICATE-----
`;

const KEY_PEM = `-----BEGIN PRIVATE KEY-----
MIGHAgEAMBMGByqGSM49AgEGCCqGSM49AwEHBG0wawIBAQQg31vTyklPF4G086zW
FKasUATJ/yq0pXm6gP0yNYZ/jcGhRANCAAR4KrH4Eb0fAOJFn+vNJGe94KLBVJoF
xL3Q8mIUz0dGYSZXKrz7L099N5/wcZzghJ12aI0/T4uYeNrZs6gBO7f1
-----END PRIVATE KEY-----
`;

/** Files that a master reads when it starts, and the options that name them. */
const FILES = [
  { path: 'resume-token.key', content: 'aGVsbG8gaGVsbG8gaGVsbG8gaGVsbG8gaGVsbG8gaGU=\n' },
  { path: 'grants/one.json', content: '' },
  { path: 'running/one.session', content: '' },
  { path: 'history/one.json', content: '' },
  { path: 'tls/authority.pem', content: CERTIFICATE_PEM },
  { path: 'tls/authority.key', content: KEY_PEM },
  { path: 'tls/leaf.pem', content: CERTIFICATE_PEM },
  { path: 'tls/leaf.key', content: KEY_PEM },
  { path: 'config.json', content: '', flag: '--config' },
  { path: 'certificate.pem', content: CERTIFICATE_PEM, flag: '--tls-certificate' },
  { path: 'key.pem', content: KEY_PEM, flag: '--tls-key' },
] as const;

const GRANT = {
  id: '5f0c2d5c-6d0b-4d6d-9f0a-2f6a5a1e9a01',
  label: 'class',
  role: 'player',
  target: '/devices',
  createdMs: 1_795_000_000_000,
  expiresMs: 1_999_000_000_000,
  codeExpiresMs: 1_999_000_000_000,
  closedMs: 1_999_000_000_000,
  maxJoins: 0,
  readTopics: ['/room/*'],
  writeTopics: ['/room/a'],
  isTerminal: false,
  token: 'A'.repeat(43),
  code: 'B'.repeat(43),
  revokedMs: 0,
  joins: 1,
  credentialsEndMs: 1_999_000_000_000,
};
const CONFIG = {
  port: 0,
  lan: false,
  name: 'fuzz',
  checks: 'warn',
  limits: 'clients=100',
  logLevel: 'info',
};
const RUNNING = { name: 'comes back', processingModules: [{ name: 'mirror-pointer' }] };

/** Files on disk when a master starts. An input is the number of a file, a line feed, and its bytes. */
export const start: Entrance = {
  name: 'start',
  about: 'files that a master starts with: keys, grants, certificates, config, what ran',
  kind: 'start',
  seeds: () =>
    FILES.map(({ path, content }, index) => {
      const json = path.startsWith('grants') ? GRANT : path === 'config.json' ? CONFIG : RUNNING;
      return Buffer.from(
        `${index}\n${content === '' ? JSON.stringify(json, undefined, 2) : content}`,
      );
    }),
  mutate(random: Random, seed, other) {
    const at = seed.indexOf(10) + 1;
    const body = seed.subarray(at);
    const isJson = body[0] === 0x7b;
    const changed =
      isJson && !random.oneIn(3)
        ? Buffer.from(
            JSON.stringify(mutateJson(random, JSON.parse(Buffer.from(body).toString()))) ?? 'null',
          )
        : mutateBytes(random, body, other);
    return joined(seed.subarray(0, at), changed);
  },
  async deliver(input, { program }) {
    const at = input.indexOf(10) + 1;
    const file =
      FILES[Number(Buffer.from(input.subarray(0, at)).toString()) % FILES.length] ?? FILES[0];
    const dataDir = mkdtempSync(join(tmpdir(), 'ubii-start-'));
    try {
      for (const folder of ['grants', 'running', 'history', 'tls'])
        mkdirSync(join(dataDir, folder));
      for (const { path, content } of FILES) {
        if (content === CERTIFICATE_PEM || content === KEY_PEM)
          writeFileSync(join(dataDir, path), content);
      }
      writeFileSync(join(dataDir, file.path), input.subarray(at));
      if (file.path.startsWith('tls/')) await startInNetworkOfItsOwn(dataDir, program);
      else await startWith(dataDir, 'flag' in file ? file.flag : undefined, program);
    } finally {
      rmSync(dataDir, { recursive: true, force: true });
    }
  },
};

/** It starts and answers, or ends with code 1 and says why without a stack. */
async function startWith(
  dataDir: string,
  flag: string | undefined,
  program: string,
): Promise<void> {
  const isTls = flag === '--tls-certificate' || flag === '--tls-key';
  const flags = isTls
    ? ['--tls-certificate', join(dataDir, 'certificate.pem'), '--tls-key', join(dataDir, 'key.pem')]
    : flag === '--config'
      ? ['--config', join(dataDir, 'config.json')]
      : [];
  const started = await startOrRefuse({ program, dataDir, flags });
  if (started === undefined) return;
  const status = await fetch(new URL('/health', started.endpoints.url)).then(
    (response) => response.status,
    (error: unknown) => String(error),
  );
  await started.stop();
  if (status !== 200) throw new Error(`It started, but /health said ${status}.`);
}

/** The authority of the data directory is read where others than this machine can reach the master. */
async function startInNetworkOfItsOwn(dataDir: string, program: string): Promise<void> {
  if (process.platform !== 'linux' || process.getuid?.() !== 0) return;
  const within = ['unshare', '--net', 'sh', '-c', 'ip link set lo up && exec "$@"', 'alone'];
  const started = await startOrRefuse({ program, dataDir, within, network: ['--lan', 'on'] });
  await started?.stop();
}

async function startOrRefuse(options: MasterStart): Promise<MasterProcess | undefined> {
  try {
    return await MasterProcess.start(options);
  } catch (error) {
    if (!(error instanceof StartRefused)) throw error;
    const isStack = /^\s+at .+:\d+:\d+\)?$/m.test(error.output);
    if (error.exitCode !== 1 || error.output.trim() === '' || isStack) {
      throw new Error(`It should end with 1, and no stack. ${error.message.slice(0, 2_000)}`, {
        cause: error,
      });
    }
    return undefined;
  }
}
