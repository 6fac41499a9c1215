import { spawn } from 'node:child_process';
import { statSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

import { BUILT_MASTER } from '@ubii/harness';

import type { Finding } from './attack.ts';
import { ATTACKS } from './attacks/index.ts';
import { AttackEnvironment } from './environment/attack-environment.ts';
import { AttackNetwork, Dialer } from './environment/attack-network.ts';

/** Result of one attack. */
interface AttackReport {
  readonly attack: string;
  readonly about: string;
  readonly findings: readonly Finding[];
  /** Why it could not be tried. */
  readonly problem?: string;
}

/** One attack as lines of text. */
function formatReport({ attack, about, findings, problem }: AttackReport): string {
  const rows = findings.map(
    ({ what, figure, aim, verdict }) =>
      `  ${verdict.padEnd(7)} ${what}: ${figure}${verdict === 'figure' ? '' : ` (aim: ${aim})`}`,
  );
  if (problem !== undefined) rows.push(`  untried could not be tried: ${problem}`);
  return [`${attack}: ${about}`, ...rows].join('\n');
}

const HELP = `Attacks a built master, and says what becomes of it and of others.

  npm run attack                              every attack, some ten minutes
  npm run attack -- --only proxies,shares

  --build <place>   another build: its repository, or its main file
  --only <name>,…   ${ATTACKS.map(({ name }) => name).join(', ')}
  --json <file>     the figures as JSON, too
  --help            this text

Strangers, players and participants come from a second network namespace, which takes root on Linux.
Elsewhere they come over loopback with the header of a proxy, and attacks over IPv6 are left out.
Ends with 1 when something breaks.`;

const { values } = parseArgs({
  options: {
    build: { type: 'string' },
    only: { type: 'string' },
    json: { type: 'string' },
    outside: { type: 'string' },
    help: { type: 'boolean', short: 'h' },
  },
});

if (values.help) console.log(HELP);
else if (values.outside === undefined) await runInNetwork();
else await runAttacks(values.outside === 'none' ? undefined : values.outside);

/** Runs itself once more, in a network that is made for it and goes with it. */
async function runInNetwork(): Promise<void> {
  const reason = AttackNetwork.reasonAgainst();
  if (reason !== undefined) {
    console.warn(`No second network: ${reason}. Everybody comes over loopback.`);
    return runAttacks(undefined);
  }
  const network = new AttackNetwork();
  const removeWithUs = (): void => network.close();
  process.once('exit', removeWithUs);
  network.open();
  const node = [process.execPath, '--import', import.meta.resolve('tsx')];
  const own = [fileURLToPath(import.meta.url), ...process.argv.slice(2)];
  const command = ['netns', 'exec', network.inside, ...node, ...own, '--outside', network.outside];
  const child = spawn('ip', command, { stdio: 'inherit' });
  for (const signal of ['SIGINT', 'SIGTERM'] as const) process.on(signal, () => child.kill(signal));
  process.exitCode = await new Promise<number>((done) =>
    child.once('exit', (code) => done(code ?? 1)),
  );
}

async function runAttacks(outside: string | undefined): Promise<void> {
  const wanted = values.only?.split(',') ?? ATTACKS.map(({ name }) => name);
  const attacks = ATTACKS.filter(({ name }) => wanted.includes(name));
  if (attacks.length !== wanted.length) {
    console.error(`--only needs names of ${ATTACKS.map(({ name }) => name).join(', ')}.`);
    process.exitCode = 2;
    return;
  }
  const dialer = new Dialer(outside);
  const environment = new AttackEnvironment(programOf(values.build), dialer, outside !== undefined);
  process.once('SIGTERM', () => process.exit(1));
  process.once('SIGINT', () => process.exit(1));
  const reports: AttackReport[] = [];
  for (const { name, about, run } of attacks) {
    let report: AttackReport;
    try {
      report = { attack: name, about, findings: await run(environment) };
    } catch (error) {
      report = { attack: name, about, findings: [], problem: String(error).slice(0, 800) };
    }
    await environment.clear();
    reports.push(report);
    console.log(formatReport(report));
  }
  dialer.close();
  const findings = reports.flatMap((report) => report.findings);
  const [held, broken] = ['holds', 'breaks'].map(
    (wanted) => findings.filter(({ verdict }) => verdict === wanted).length,
  ) as [number, number];
  const untried = reports.filter(({ problem }) => problem !== undefined).length;
  console.log(`${held} hold, ${broken} break, ${untried} attacks untried`);
  if (values.json !== undefined) {
    const summary = { program: environment.program, hasNetwork: environment.hasNetwork, reports };
    writeFileSync(fromCaller(values.json), `${JSON.stringify(summary, undefined, 2)}\n`);
  }
  process.exit(broken + untried > 0 ? 1 : 0);
}

/** A repository is as good as its build. */
function programOf(place: string | undefined): string {
  if (place === undefined) return BUILT_MASTER;
  const path = fromCaller(place);
  return statSync(path).isDirectory() ? join(path, 'apps', 'master', 'dist', 'main.js') : path;
}

function fromCaller(path: string): string {
  return resolve(process.env['INIT_CWD'] ?? process.cwd(), path);
}
