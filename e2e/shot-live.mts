import { createRequire } from 'node:module';
import { chromium } from '@playwright/test';
import { SERVICES } from '@ubii/proto';
import { createClient } from '@ubii/client-web/node';
import { MasterProcess } from './fixtures/master-process.ts';
import { callService } from './fixtures/call-service.ts';
import { placedSession } from './fixtures/placed-session.ts';
const out = '/tmp/live';
const only = process.argv.slice(2);
const wants = (n: string) => only.length === 0 || only.some((o) => n.includes(o));
const master = await MasterProcess.start();
const b = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox','--disable-quic','--no-first-run','--disable-background-networking','--disable-component-update','--disable-sync','--use-angle=swiftshader','--enable-unsafe-swiftshader','--ignore-gpu-blocklist'] });
const sleep = (ms: number) => new Promise((r) => setTimeout(r, ms));
let go = true;
try {
  const call = (r: any) => callService(master.addresses, r);
  const id = await placedSession(master, { copy: { x: 300, y: 100, reads: '/lab/angle', writes: '/lab/copied' } });
  await call({ topic: SERVICES.sessionRuntimeStart.topic, session: { id } });
  const robot = createClient({ name: 'Robot arm', masterUrl: master.url, url: master.url } as any);
  await robot.connect();
  void (async () => { for (let n = 0; go; n++) { robot.publish('/lab/angle', 'double', Math.sin(n / 9), { immediate: true }); robot.publish('/lab/hand', 'vector3', { x: Math.sin(n / 7), y: Math.cos(n / 5), z: n % 9 / 9 }, { immediate: true }); if (n % 12 === 0) robot.publish('/lab/label', 'string', n % 24 ? 'swipe' : 'rest', { immediate: true }); await sleep(50); } })();
  const rec = (await call({ topic: SERVICES.recordingStart.topic, recordingStartRequest: { name: 'Gesture study, P07' } })).recording!;
  await sleep(8000);
  await call({ topic: SERVICES.recordingStop.topic, recordingRequest: { id: rec.id } });
  const themes = [['dark', 1440], ['light', 1440], ['dark', 390], ['light', 390]] as const;
  for (const [scheme, width] of themes) {
    const ctx = await b.newContext({ baseURL: master.url.replace('127.0.0.1', 'localhost'), colorScheme: scheme, viewport: { width, height: width < 500 ? 844 : 900 }, hasTouch: width < 500, isMobile: width < 500 });
    const p = await ctx.newPage();
    p.on('console', (m) => m.type() === 'error' && console.log(m.text()));
    const shot = async (n: string) => { await sleep(700); await p.screenshot({ path: `${out}/${n}-${scheme}-${width}.png` }); };
    const click = async (role: any, name: any) => { await p.getByRole(role, { name }).first().click({ timeout: 6000 }).catch((e) => console.log(String(e).slice(0, 300))); };
    await p.goto(`/recordings/${rec.id}`); await sleep(3000);
    await shot('view');
    await click('radio', 'Live topics'); await sleep(1500);
    await click('radio', 'Some topics'); await p.getByText('Names and time stamps').click(); await click('button', 'Rename a prefix');
    await shot('dialog');
    await click('radio', 'All topics'); await click('radio', 'Mute');
    await click('button', 'Play live'); await sleep(2500);
    await shot('live');
    const q = await ctx.newPage();
    await q.goto('/'); await sleep(2500); await q.screenshot({ path: `${out}/home-${scheme}-${width}.png` });
    await q.goto('/topics/%2Flab%2Fangle'); await sleep(2500); await q.screenshot({ path: `${out}/topic-${scheme}-${width}.png` });
    await q.close();
    await click('button', 'Play on this page only'); await sleep(700);
    await p.keyboard.press('o'); await sleep(500);
    await click('button', /^Actions for the span/); await sleep(300); await shot('span');
    await click('menuitem', 'Make a ghost'); await sleep(600); await shot('ghost');
    await p.getByLabel('Copies').fill('3').catch(() => {}); await click('button', 'Start'); await sleep(1500);
    await shot('ghosts');
    if (width < 500) { await click('radio', 'Graph'); await sleep(800); }
    await click('button', /^Run today/); await sleep(1800); await shot('rerun'); await sleep(9000); await shot('compared');
    if (width < 500) { await p.goto('/recordings'); await sleep(1500); await shot('list'); }
    for (const r of (await call({ topic: (SERVICES as any).replayList.topic })).replayList?.elements ?? []) await call({ topic: (SERVICES as any).replayStop.topic, replayRequest: { id: r.id } });
    await ctx.close();
  }
  go = false; await robot.close();
} finally { go = false; await b.close(); await master.dispose(); }
