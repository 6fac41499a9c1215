import { expect, test as base, type Page } from '@playwright/test';
import type { SandboxPage } from '../../../packages/pm-sandbox/test/browser-page.ts';
import { serveBrowserPage } from '../../../packages/pm-sandbox/test/serve-browser-page.mjs';

type Outcome = Awaited<ReturnType<SandboxPage['runModule']>>;
type ModuleInit = Parameters<SandboxPage['runModule']>[0];

/** Runs modules in the sandboxes of a page. */
class ModulesPage {
  readonly #page: Page;
  /** Paths the server was asked for. */
  readonly requests: readonly string[];

  constructor(page: Page, requests: readonly string[]) {
    this.#page = page;
    this.requests = requests;
  }

  run(init: ModuleInit, isTrusted: boolean): Promise<Outcome> {
    return this.#page.evaluate(
      ([given, trusted]) =>
        (globalThis as unknown as { sandboxPage: SandboxPage }).sandboxPage.runModule(
          given,
          trusted,
        ),
      [init, isTrusted] as const,
    );
  }

  /** Result of a function body, as text. */
  async textOf(body: string, isTrusted: boolean): Promise<unknown> {
    const onProcessing = `async (dt, inputs, state) => {
      const result = await (async () => { ${body} })();
      return { outputs: { out: { string: String(result) } } };
    }`;
    const { values, fault } = await this.run({ onProcessing }, isTrusted);
    return fault ?? values['out'];
  }

  passImage(isTrusted: boolean): ReturnType<SandboxPage['passImage']> {
    return this.#page.evaluate(
      (trusted) =>
        (globalThis as unknown as { sandboxPage: SandboxPage }).sandboxPage.passImage(trusted),
      isTrusted,
    );
  }
}

const test = base.extend<{ modules: ModulesPage }>({
  modules: async ({ page }, use) => {
    const server = await serveBrowserPage();
    await page.goto(server.url);
    await use(new ModulesPage(page, server.requests));
    server.close();
  },
});

/** Ways out of a worker; each tells a path that the server would see. */
const WAYS_OUT = [
  'await fetch("/out-fetch")',
  'await new Promise((resolve, reject) => { const request = new XMLHttpRequest(); request.open("GET", "/out-xhr"); request.onload = resolve; request.onerror = reject; request.send() })',
  'importScripts("/out-import-scripts")',
  'await import("/out-import")',
  'new Worker("/out-worker")',
  'new WebSocket(location.origin.replace("http", "ws") + "/out-socket")',
  'new EventSource("/out-event-source")',
  'navigator.sendBeacon("/out-beacon")',
  'await caches.open("x")',
  'await new Promise((resolve, reject) => { const open = indexedDB.open("x"); open.onsuccess = resolve; open.onerror = reject })',
  'new BroadcastChannel("x").postMessage(1)',
  'self.postMessage({ messages: [] })',
  'close()',
  'EventTarget.prototype.addEventListener.call(self, "message", () => undefined)',
  'new OffscreenCanvas(1, 1).addEventListener.call(self, "message", () => undefined)',
  'Object.create(OffscreenCanvas.prototype).addEventListener("message", () => undefined)',
  'navigator.serviceWorker.getRegistrations()',
  'await new (async () => {}).constructor("return fetch(\\"/out-constructed\\")")()',
];

for (const [kind, isTrusted] of [
  ['sandboxed', false],
  ['trusted', true],
] as const) {
  test.describe(`${kind} code in a browser`, () => {
    test('computes, writes to its console, and keeps pictures whole [PM-36]', async ({
      modules,
    }) => {
      const onProcessing =
        '() => { console.log("hello"); return { outputs: { out: { string: "x" } } } }';
      expect(await modules.run({ onProcessing }, isTrusted)).toMatchObject({
        values: { out: 'x' },
        lines: ['log: hello'],
      });
      expect(await modules.passImage(isTrusted)).toEqual({ sum: '16384', isTransferred: true });
    });

    test('has no way out of its worker [PM-52]', async ({ modules }) => {
      for (const way of WAYS_OUT) {
        const body = `try { ${way}; return 'out' } catch (error) { return 'stays' }`;
        expect(await modules.textOf(body, isTrusted), way).toBe('stays');
      }
      expect(modules.requests.filter((path) => path.startsWith('/out'))).toEqual([]);
    });

    test('is ended when it does not end, and named [PM-53]', async ({ modules }) => {
      for (const onProcessing of [
        '() => { for (;;) {} }',
        'async () => { await null; for (;;) {} }',
        '() => { const all = []; for (;;) all.push(new Array(1000).fill(0)) }',
      ]) {
        const { fault } = await modules.run({ onProcessing }, isTrusted);
        expect(fault).toMatchObject({ phase: 'onProcessing' });
        expect(['timeout', 'memory']).toContain(fault?.kind);
        expect(await modules.textOf('return 1 + 1', isTrusted)).toBe('2');
      }
    });

    test('tells where it failed [PM-13]', async ({ modules }) => {
      const onProcessing = '() => {\n  const a = 1;\n  throw new Error("here");\n}';
      expect((await modules.run({ onProcessing }, isTrusted)).fault).toMatchObject({
        kind: 'threw',
        message: 'here',
        line: 3,
      });
    });

    test('changes nothing of the page [PM-56]', async ({ modules, page }) => {
      const onProcessing = `() => {
        Object.prototype.polluted = 1;
        return { outputs: { out: { string: JSON.parse('{"__proto__":{"polluted":1}}') } } };
      }`;
      const { faults } = await modules.run({ onProcessing }, isTrusted);
      expect(faults).toMatchObject([{ kind: 'output' }]);
      expect(await page.evaluate(() => 'polluted' in {})).toBe(false);
    });
  });
}
