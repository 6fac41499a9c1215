import type { Page } from '@playwright/test';
import { expect, test } from '../../fixtures/test.ts';

/** Runs code before that of each worker for trusted modules. */
async function beforeWorkers(page: Page, code: string): Promise<void> {
  await page.route('**/sandbox/trusted-worker.js', async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, body: `${code}\n${await response.text()}` });
  });
}

/** Software WebGL passes for a graphics card, and its numbers are a quarter too large. */
const WRONG_NUMBERS = `
  const UNMASKED_RENDERER_WEBGL = 0x9246;
  const gl = WebGL2RenderingContext.prototype;
  const { getParameter } = gl;
  gl.getParameter = function (name) {
    return name === UNMASKED_RENDERER_WEBGL ? 'A graphics card' : getParameter.call(this, name);
  };
  for (const name of ['readPixels', 'getBufferSubData']) {
    const method = gl[name];
    gl[name] = function (...args) {
      method.apply(this, args);
      const numbers = args.find((one) => one instanceof Float32Array);
      numbers?.forEach((number, index) => (numbers[index] = number * 1.25));
    };
  }
`;

/** The browser takes the contexts for computing away when it is told to. */
const LOST_CONTEXT = `
  const contexts = [];
  // Before the worker takes away what its modules may not use.
  new BroadcastChannel('lose contexts').onmessage = () => {
    for (const context of contexts) context.getExtension('WEBGL_lose_context').loseContext();
  };
  const { getContext } = OffscreenCanvas.prototype;
  OffscreenCanvas.prototype.getContext = function (...args) {
    const context = getContext.apply(this, args);
    if (args[0] === 'webgl2' && this.width > 1) contexts.push(context);
    return context;
  };
`;

test('the example says which backend has wrong numbers, and detects with another one [PM-97]', async ({
  room,
}) => {
  const { page } = await room.atDesk('Anna');
  await beforeWorkers(page, WRONG_NUMBERS);
  await page.goto('/examples/object-detection');
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await expect(page.getByRole('main')).toContainText(
    'webgl does not work: Its numbers differ from the reference by 25.0 %. wasm replaces it.',
    { timeout: 30_000 },
  );
  await expect(page.locator('[data-label="cup"]').first()).toBeAttached();
});

test('a backend that is lost while it computes is replaced, and the page says why [PM-97]', async ({
  room,
}) => {
  test.setTimeout(360_000);
  const { page } = await room.atDesk('Anna');
  await beforeWorkers(page, LOST_CONTEXT);
  await page.goto('/examples/image-processing');
  await page.getByRole('combobox', { name: 'Module' }).click();
  await page.getByRole('option', { name: /^object-detection/ }).click();
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  const outputs = page.getByRole('region', { name: 'Outputs' });
  const output = (name: string) =>
    outputs.getByRole('listitem').filter({ has: page.getByRole('link', { name, exact: true }) });
  await expect(output('backend')).toContainText('wasm', { timeout: 30_000 });
  await page.getByRole('combobox', { name: 'backend', exact: true }).selectOption('webgl');
  // Software WebGL compiles for a minute on a busy machine.
  await expect(output('backend')).toContainText('webgl', { timeout: 150_000 });
  await page.evaluate(() => new BroadcastChannel('lose contexts').postMessage('now'));
  await expect(output('backend')).toContainText('wasm', { timeout: 90_000 });
  await expect(output('backendFault')).toContainText('The WebGL context was lost.');
  await expect(page.locator('[data-shape="cup"]').first()).toBeAttached();
});
