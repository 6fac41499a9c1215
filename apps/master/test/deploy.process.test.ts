import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, existsSync, readFileSync, writeFileSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readOptions } from '@ubii/program';
import { temporaryFolder } from '@ubii/program/testing';
import { startNats } from '@ubii/harness';
import { SystemClock } from '@ubii/timing/system';
import { afterAll, beforeAll, beforeEach, describe, expect, it, onTestFinished, vi } from 'vitest';
import { parse } from 'yaml';
import { parseCluster } from '../src/adapters/config/cluster-address.ts';
import { MASTER_PROGRAM } from '../src/adapters/config/config.ts';
import { openCluster } from '../src/adapters/nats/open-cluster.ts';
import { RecordingLog } from '../src/testing/recording-log.ts';

/** A service of `compose.yaml`, as far as it is checked. */
interface Service {
  readonly image: string;
  readonly working_dir?: string;
  readonly environment: Readonly<Record<string, string | number>>;
  readonly volumes: readonly string[];
  readonly secrets?: readonly string[];
  readonly build?: { readonly context: string; readonly dockerfile: string };
}

const root = fileURLToPath(new URL('../../..', import.meta.url));
const read = (path: string): string => readFileSync(join(root, path), 'utf8');
const compose = parse(read('deploy/compose.yaml'), { merge: true }) as {
  readonly services: Readonly<Record<string, Service>>;
  readonly secrets: Readonly<Record<string, { readonly file: string }>>;
};
const { nats, ...masters } = compose.services as Record<string, Service> & { nats: Service };

const hasOpenssl = spawnSync('openssl', ['version']).status === 0;

/** A copy of `deploy` with secrets. */
let folder: string;
beforeAll(() => {
  folder = temporaryFolder((remove) => afterAll(remove));
  const isSource = (source: string): boolean => !source.endsWith('/secrets');
  cpSync(join(root, 'deploy'), folder, { recursive: true, filter: isSource });
  if (hasOpenssl) makeSecrets();
});
beforeEach(({ skip }) => skip(!hasOpenssl, 'openssl is not installed'));

function makeSecrets(...names: readonly string[]): void {
  execFileSync('sh', [join(folder, 'make-secrets.sh'), ...names], { stdio: 'pipe' });
}

describe('compose.yaml', () => {
  it('starts masters with options that exist, on ports of their own', () => {
    const options = Object.values(masters).map(({ environment }) => {
      const texts = Object.entries(environment).map(([key, value]) => [key, String(value)]);
      const env = Object.fromEntries(texts) as Record<string, string>;
      const { values, given } = readOptions(MASTER_PROGRAM, [], env, '/ubii');
      expect(given.size).toBe(texts.length); // Each variable is an option.
      return values;
    });
    const ports = options.flatMap(({ port, legacyPorts }) => [
      port,
      ...(legacyPorts === undefined ? [] : [legacyPorts.services, legacyPorts.topicData]),
    ]);
    expect(new Set(ports).size).toBe(ports.length);
    expect(new Set(options.map(({ name }) => name)).size).toBe(3);
    for (const { cluster, clusterCa, clusterCredentials } of options) {
      expect(cluster?.servers).toEqual([`tls://localhost:4222`]);
      expect(nats.environment.NATS_LISTEN).toBe('127.0.0.1:4222');
      expect([clusterCa, clusterCredentials]).toEqual(
        ['ca.pem', 'nats-login'].map((name) => `/run/secrets/${name}`),
      );
    }
  });

  it('mounts files that exist once the secrets are made, and all that NATS reads', () => {
    const secrets = Object.values(compose.secrets).map(({ file }) => file);
    const mounts = nats.volumes.flatMap((volume) => {
      const [source = '', target = ''] = volume.split(':');
      return source.startsWith('./') ? [{ source, target }] : [];
    });
    for (const file of [...secrets, ...mounts.map(({ source }) => source)]) {
      expect(existsSync(join(folder, file)), file).toBe(true);
    }
    const named = [...read('deploy/nats.conf').matchAll(/"(secrets\/[^"]+)"/g)].map(([, path]) =>
      join(nats.working_dir!, path!),
    );
    expect(named).toHaveLength(3);
    expect(mounts.map(({ target }) => target)).toEqual(expect.arrayContaining(named));
    for (const { secrets: used } of Object.values(masters)) {
      expect(Object.keys(compose.secrets)).toEqual(used);
    }
  });

  it('builds and runs images of exact versions', () => {
    const dockerfile = read('deploy/Dockerfile');
    const bases = [...dockerfile.matchAll(/^FROM (\S+)/gm)].map(([, image]) => image!);
    for (const image of [nats.image, ...bases]) expect(image).toMatch(/:\d+\.\d+\.\d+-/);
    const { packageManager } = JSON.parse(read('package.json')) as { packageManager: string };
    expect(dockerfile).toContain(`npx -y ${packageManager} install --frozen-lockfile`);
    for (const { build } of Object.values(masters)) {
      expect(existsSync(join(root, 'deploy', build!.context, build!.dockerfile))).toBe(true);
    }
    const flags = JSON.parse(read('apps/master/node-flags.json')) as readonly string[];
    const command = ['node', ...flags, 'apps/master/dist/main.js'];
    expect(dockerfile).toContain(`ENTRYPOINT ${JSON.stringify(command).replaceAll(',', ', ')}`);
    const copied = [...dockerfile.matchAll(/^COPY --from=build \/source\/(\S+)/gm)];
    expect(copied.length).toBeGreaterThan(4);
    for (const [, path] of copied) {
      expect(existsSync(join(root, path!.replace(/dist$/, '')))).toBe(true);
    }
  });
});

describe('the guide on scale', () => {
  it('starts masters with options that exist', () => {
    const lines = [...read('docs/guides/scale.md').matchAll(/^npm start -- (.*)$/gm)];
    expect(lines.length).toBeGreaterThan(2);
    for (const [, args] of lines) {
      const { values } = readOptions(MASTER_PROGRAM, args!.split(' '), {}, '/ubii');
      expect(values.cluster).toBeDefined();
    }
  });
});

describe('make-secrets.sh', () => {
  it('keeps what exists, and refuses names that the certificate has not', () => {
    const login = readFileSync(join(folder, 'secrets/nats-login'), 'utf8');
    makeSecrets('localhost', '127.0.0.1');
    expect(readFileSync(join(folder, 'secrets/nats-login'), 'utf8')).toBe(login);
    for (const name of ['10.0.0.7', 'nats.example.org', 'fd00::7']) {
      expect(() => makeSecrets(name)).toThrow(`nats.pem is not for ${name}. Remove it`);
    }
  });
});

describe('nats.conf', () => {
  it('admits only masters that have the login and the authority of make-secrets.sh', async () => {
    setNatsVariables();
    const server = await startNats({ args: ['--config', 'nats.conf'], cwd: folder });
    onTestFinished(() => server.stop());
    const enter = (names: { readonly ca?: string; readonly login?: string }) =>
      openCluster({
        address: parseCluster(`tls://localhost:${server.port}`),
        name: 'ubii',
        caFile: names.ca && join(folder, 'secrets', names.ca),
        credentialsFile: names.login && join(folder, 'secrets', names.login),
        masterName: 'master-a',
        frameBytes: 1000,
        clock: new SystemClock(),
        log: new RecordingLog(),
      });
    const opened = await enter({ ca: 'ca.pem', login: 'nats-login' });
    await opened.storage.sessions.write('one', {});
    await opened.close();
    await expect(enter({ login: 'nats-login' })).rejects.toThrow('Name the authority');
    await expect(enter({ ca: 'ca.pem' })).rejects.toThrow('give --cluster-credentials');
  });

  it('is read by nats-server, also as one of three', () => {
    setNatsVariables();
    const check = (file: string): Buffer =>
      execFileSync(findProgram('nats-server')!, ['-t', '--config', file], {
        cwd: folder,
        stdio: 'pipe',
      });
    check('nats-three.conf');
    vi.stubEnv('NATS_ROUTES', undefined);
    expect(() => check('nats-three.conf')).toThrow('NATS_ROUTES');
  });
});

describe('haproxy.cfg', () => {
  it('has the masters of compose.yaml', () => {
    const servers = [
      ...read('deploy/haproxy.cfg').matchAll(/^ {2}server \S+ 127\.0\.0\.1:(\d+)/gm),
    ];
    const ports = Object.values(masters).map(({ environment }) => String(environment.UBII_PORT));
    expect(servers.map(([, port]) => port)).toEqual(ports);
  });

  it('is read by haproxy', ({ skip }) => {
    const program = findProgram('haproxy');
    skip(program === undefined, 'haproxy is not installed');
    const file = join(folder, 'haproxy.cfg');
    const pem = join(folder, 'ubii.pem');
    const secret = (name: string): string => readFileSync(join(folder, 'secrets', name), 'utf8');
    writeFileSync(pem, secret('nats.pem') + secret('nats-key.pem'));
    writeFileSync(file, read('deploy/haproxy.cfg').replace('/etc/haproxy/ubii.pem', pem));
    execFileSync(program!, ['-c', '-f', file], { stdio: 'pipe' });
  });
});

function setNatsVariables(): void {
  const store = temporaryFolder();
  vi.stubEnv('NATS_NAME', 'nats');
  vi.stubEnv('NATS_LISTEN', '127.0.0.1:4222'); // Replaced by a free port where it listens.
  vi.stubEnv('NATS_MONITOR', '127.0.0.1:0');
  vi.stubEnv('NATS_STORE', store);
  vi.stubEnv('NATS_ROUTE_LISTEN', '127.0.0.1:6222');
  vi.stubEnv('NATS_ROUTES', '[tls://10.0.0.12:6222, tls://10.0.0.13:6222]');
  onTestFinished(() => void vi.unstubAllEnvs());
}

/** Debian has both where only the PATH of root looks. */
function findProgram(name: string): string | undefined {
  const folders = [...(process.env.PATH ?? '').split(delimiter), '/usr/sbin', '/usr/local/sbin'];
  return folders.map((each) => join(each, name)).find((path) => existsSync(path));
}
