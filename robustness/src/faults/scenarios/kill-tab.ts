import { existsSync } from 'node:fs';

import { chromium, type Browser, type CDPSession, type Page } from '@playwright/test';

import { periodicSession } from '../../fixtures/sessions.ts';
import { FaultRun, type Scenario } from '../fault-run.ts';
import { ModuleOutput } from '../module-output.ts';

const SYSTEM_CHROMIUM = '/usr/bin/chromium';
/** The browser asks only the master. Its sandbox does not start as root. */
const FLAGS: readonly string[] = [
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

export const killTab: Scenario = {
  name: 'kill-tab',
  about:
    'kill -9 of a browser tab that runs the module of a session, and a reload of the crashed tab',
  reasonAgainst() {
    const path = chromiumPath();
    return existsSync(path) ? undefined : `there is no Chromium at "${path}"`;
  },
  async run({ program, random, times }) {
    const faultRun = await FaultRun.open({ program }, random);
    const losses: string[] = [];
    const backMs: number[] = [];
    let browser: Browser | undefined;
    let moduleOutput: ModuleOutput | undefined;
    try {
      browser = await chromium.launch({ executablePath: chromiumPath(), args: [...FLAGS] });
      const { url } = faultRun.master.endpoints;
      const tab = await CrashingTab.open(browser, url);
      const nodeId = await tab.becomeNode();
      const session = periodicSession('in a tab', '/tab/tick');
      const { session: running } = await faultRun.master.call({
        topic: '/services/session/runtime/start',
        session: {
          ...session,
          processingModules: session.processingModules!.map((one) => ({ ...one, nodeId })),
        },
      });
      moduleOutput = await ModuleOutput.open(url, '/tab/tick');
      await moduleOutput.waitForMore();
      for (let index = 0; index < times; index++) {
        await faultRun.workFor(random.below(1_500));
        await tab.kill();
        const begunMs = performance.now();
        tab.reload();
        await moduleOutput.waitForMore();
        backMs.push(performance.now() - begunMs);
        if ((await tab.clientId()) !== nodeId) losses.push('the tab came back as another client');
        const { session: now } = await faultRun.ask({
          topic: '/services/session/runtime/get',
          session: { id: running!.id },
        });
        if (now === undefined) losses.push('the session is gone');
        losses.push(...(await faultRun.findLosses()));
      }
      return faultRun.outcome(losses, backMs);
    } finally {
      await moduleOutput?.close();
      await browser?.close();
      await faultRun.close();
    }
  },
};

function chromiumPath(): string {
  const chosen = process.env['UBII_CHROMIUM'];
  if (chosen) return chosen;
  return existsSync(SYSTEM_CHROMIUM) ? SYSTEM_CHROMIUM : chromium.executablePath();
}

/**
 * A tab whose renderer process is ended, and that is reloaded as with the button of the browser's crash page. Playwright
 * gives a crashed page up, the DevTools protocol does not.
 */
class CrashingTab {
  readonly #browser: CDPSession;
  readonly #page: Page;
  readonly #tab: CDPSession;

  private constructor(browser: CDPSession, page: Page, tab: CDPSession) {
    this.#browser = browser;
    this.#page = page;
    this.#tab = tab;
  }

  static async open(browser: Browser, url: string): Promise<CrashingTab> {
    const page = await browser.newPage();
    const tab = await page.context().newCDPSession(page);
    await page.goto(new URL('/settings', url).href);
    return new CrashingTab(await browser.newBrowserCDPSession(), page, tab);
  }

  /** Turns on that the tab runs modules. @returns id of its client */
  async becomeNode(): Promise<string> {
    await this.#page.getByRole('switch', { name: /^Run modules in this tab/ }).click();
    await this.#page.getByRole('status').filter({ hasText: 'Ready' }).waitFor();
    return this.clientId();
  }

  async clientId(): Promise<string> {
    const { result } = await this.#tab.send('Runtime.evaluate', {
      expression: `JSON.parse(sessionStorage.getItem('ubii.identity')).clientId`,
    });
    return String(result.value);
  }

  /** Ends the renderers of the browser, of which this tab has one, with SIGKILL. */
  async kill(): Promise<void> {
    const crashed = new Promise<void>((resolve) => {
      this.#tab.once('Inspector.targetCrashed', () => resolve());
    });
    await this.#tab.send('Inspector.enable');
    const { processInfo } = await this.#browser.send('SystemInfo.getProcessInfo');
    for (const { type, id } of processInfo) if (type === 'renderer') process.kill(id, 'SIGKILL');
    await crashed;
  }

  /** Starts the reload. A crashed page answers no command, so the records of its module have to show the end. */
  reload(): void {
    this.#tab.send('Page.reload').catch(() => undefined);
  }
}
