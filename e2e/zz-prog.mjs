import { chromium } from '@playwright/test';
import { spawn, execFileSync } from 'node:child_process';
const port = 8251;
const master = spawn('node', ['--max-semi-space-size=8', 'apps/master/dist/main.js', '--port', String(port), '--legacy-ports', 'off', '--lan', 'off', '--data-dir', '/tmp/prog/data'], { cwd: '/work/wt-program', stdio: 'inherit' });
await new Promise((r) => setTimeout(r, 4000));
const b = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'] });
let child;
try {
  for (const [theme, w, h] of [['dark', 1440, 900], ['light', 1440, 900], ['dark', 390, 844]]) {
    const c = await b.newContext({ viewport: { width: w, height: h }, colorScheme: theme });
    const p = await c.newPage();
    p.on('pageerror', (e) => console.log('PAGEERROR', e.message));
    await p.goto(`http://localhost:${port}/clients/program`);
    await p.waitForTimeout(3500);
    await p.screenshot({ path: `/tmp/prog/wait-${theme}-${w}.png` });
    if (!child) {
      const text = await p.locator('.line code').allTextContents();
      console.log(text);
      const [, install] = [0, text[0].trim()];
      execFileSync('npm', ['init', '-y'], { cwd: '/tmp/prog/app' });
      execFileSync('sh', ['-c', install], { cwd: '/tmp/prog/app', stdio: 'inherit' });
      const file = await (await fetch(`http://localhost:${port}/sdk/`)).text();
      console.log(file.slice(0, 300));
      await p.context().grantPermissions(['clipboard-read', 'clipboard-write']);
      await p.getByRole('button', { name: 'Copy first-program.mjs' }).click();
      const code = await p.evaluate(() => navigator.clipboard.readText());
      (await import('node:fs')).writeFileSync('/tmp/prog/app/first-program.mjs', code);
      child = spawn('sh', ['-c', text[1].trim()], { cwd: '/tmp/prog/app', stdio: 'inherit' });
      await p.waitForTimeout(6000);
    }
    await p.waitForTimeout(1500);
    await p.screenshot({ path: `/tmp/prog/seen-${theme}-${w}.png` });
    if (w === 1440 && theme === 'light') {
      await p.getByRole('radio', { name: /A page/ }).click();
      await p.waitForTimeout(1000);
      await p.screenshot({ path: `/tmp/prog/page-${theme}.png` });
      await p.getByRole('radio', { name: /A module/ }).click();
      await p.waitForTimeout(2500);
      await p.screenshot({ path: `/tmp/prog/module-${theme}.png` });
    }
    if (w === 390) await p.screenshot({ path: `/tmp/prog/full-390.png`, fullPage: true });
    await c.close();
  }
} finally { child?.kill('SIGINT'); await b.close(); master.kill(); }
