import { execFile, spawn, type ChildProcess } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import type { MasterProcess } from '@ubii/harness';
import { readGuide } from '../../../scripts/lib/guides.mjs';
import { expect, test } from '../../fixtures/test.ts';
import { makeGrant } from './make-grant.ts';

const GUIDE = join(import.meta.dirname, '../../../docs/guides/a-program.md');
const ADDRESS = 'http://localhost:8080';
const run = promisify(execFile);

let folder: string;
const children: ChildProcess[] = [];

test.beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'ubii-own-program-'));
});

test.afterEach(() => {
  for (const child of children.splice(0)) child.kill('SIGKILL');
  rmSync(folder, { recursive: true, force: true });
});

/** Environment of a user who has used neither npm nor this product, and has no network but the loopback. */
const environment = (): NodeJS.ProcessEnv => ({
  PATH: process.env['PATH'],
  HOME: folder,
  XDG_STATE_HOME: join(folder, 'state'),
  npm_config_cache: join(folder, 'npm-cache'),
  npm_config_registry: 'http://127.0.0.1:9/',
});

/** Starts a command of the guide. */
function start(command: string): { readonly output: () => string; readonly child: ChildProcess } {
  const [program = '', ...args] = command.split(' ');
  let output = '';
  const child = spawn(program, args, { cwd: folder, env: environment() });
  children.push(child);
  for (const stream of [child.stdout, child.stderr]) {
    stream.on('data', (data: Buffer) => (output += data.toString()));
  }
  return { output: () => output, child };
}

/** Follows the guide with the address of this master, and returns its commands that start programs. */
async function followGuide(master: MasterProcess): Promise<string[]> {
  const programs: string[] = [];
  const text = readFileSync(GUIDE, 'utf8').replaceAll(ADDRESS, master.url);
  for (const step of readGuide(text)) {
    if (step.kind === 'create') writeFileSync(join(folder, step.path), step.content);
    if (step.kind !== 'run') continue;
    for (const command of step.commands) {
      const [program = '', ...args] = command.split(' ');
      if (program === 'npm') await run(program, args, { cwd: folder, env: environment() });
      else programs.push(`${command} ${master.url}`);
    }
  }
  return programs;
}

test('a program and a page outside the repository use the library of the master @smoke', async ({
  browser,
  master,
  room,
}) => {
  const [program = '', moduleProgram = ''] = await followGuide(master);
  const ada = await room.program('ada');

  await test.step('the program publishes and answers', async () => {
    const waves = ada.subscribe('/first-program/wave', { format: 'double' });
    const answers = ada.subscribe('/first-program/seen', { format: 'int32' });
    await Promise.all([waves.ready, answers.ready]);
    const { page } = await room.atDesk('Bea');
    await page.goto('/clients/program');
    await expect(page.getByText('Waiting for first-program.mjs')).toBeVisible();
    await expect(page.getByRole('region', { name: 'first-program.mjs' })).toContainText(master.url);
    await expect(page.getByText(program, { exact: true })).toBeVisible();
    const { output, child } = start(program);
    const seen = page.getByRole('status', { name: 'first-program.mjs' });
    await expect(seen).toContainText('connected');
    await expect(seen).toContainText(/-?0\.\d/);
    await expect(seen.getByRole('link', { name: 'Open the topic' })).toBeVisible();
    for await (const { value } of waves) if (value > 0) break;
    await seen.getByRole('switch', { name: 'Lamp' }).click();
    for await (const { value } of answers) if (value === 1) break;
    expect(output()).toBe('connected as first program\nthe lamp is on\n');
    const ended = new Promise((resolve) => child.once('exit', resolve));
    child.kill('SIGINT');
    expect(await ended).toBe(0);
  });

  await test.step('a session uses the module of the program', async () => {
    const { output } = start(moduleProgram);
    await expect.poll(output).toContain('loudness is offered by first module');
    const texts = ada.subscribe('/room/text', { format: 'string' });
    await texts.ready;
    await ada.call('sessionRuntimeStart', {
      name: 'listening',
      processingModules: [{ name: 'loudness' }],
      ioMappings: [
        {
          processingModuleName: 'loudness',
          inputMappings: [{ inputName: 'level', topic: '/room/level' }],
          outputMappings: [{ outputName: 'text', topic: '/room/text' }],
        },
      ],
    });
    ada.publish('/room/level', 'double', 0.75);
    for await (const { value } of texts) if (value === 'loud') break;
  });

  const page = readFileSync(join(folder, 'first-page.html'), 'utf8');
  const context = await browser.newContext();
  const showsLamp = async (url: string): Promise<void> => {
    const tab = await context.newPage();
    await tab.goto(url);
    await expect(tab.locator('p')).toHaveText('the lamp is on');
    await tab.close();
  };

  await test.step('a page of a file uses its token, and needs it', async () => {
    const { token } = await makeGrant(master);
    const file = join(folder, 'first-page.html');
    writeFileSync(file, page.replace('TOKEN', token));
    const url = pathToFileURL(file).href;
    await showsLamp(url);
    await showsLamp(url);
    writeFileSync(file, page.replace(", joinToken: 'TOKEN'", ''));
    const tab = await context.newPage();
    await tab.goto(url);
    await expect(tab.locator('p')).toContainText('needs a token as joinToken');
  });

  await test.step('a page of another port needs none', async () => {
    const touch = readFileSync(join(folder, 'touch-page.html'), 'utf8');
    const server = createServer(({ url }, response) => {
      response.setHeader('content-type', 'text/html');
      response.end((url === '/touch' ? touch : page).replace(", joinToken: 'TOKEN'", ''));
    });
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
    const address = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
    await showsLamp(address);

    const tab = await context.newPage();
    await tab.setViewportSize({ width: 1000, height: 500 });
    await tab.goto(`${address}touch`);
    const topic = `/${ada.id}/web-interface-smart-device/touch_position`;
    ada.publish(topic, 'vector2', { x: 0.25, y: 0.5 });
    const box = () => tab.locator('div').boundingBox();
    await expect.poll(box).toMatchObject({ x: 250, y: 250 });
    server.closeAllConnections();
    server.close();
  });
  await context.close();
});
