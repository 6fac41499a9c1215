import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from '@playwright/test';
import type { Object2DList } from '@ubii/proto';
import { expect, test } from '../../fixtures/test.ts';
import { showPhoto } from '../../pages/picture-source.ts';
import { SessionPage } from '../../pages/session-page.ts';

const PHOTO = join(import.meta.dirname, '../../../packages/vision/photos/camera.jpg');

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

/**
 * The browser takes the context away in the middle of a detection: comparing numbers takes fewer draw
 * calls. A whole detection in software WebGL would take minutes on a busy machine.
 */
const LOST_CONTEXT = `
  let draws = 0;
  const gl = WebGL2RenderingContext.prototype;
  for (const name of ['drawElements', 'drawArrays']) {
    const method = gl[name];
    gl[name] = function (...args) {
      if (++draws === 60) this.getExtension('WEBGL_lose_context').loseContext();
      return method.apply(this, args);
    };
  }
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
  test.setTimeout(240_000);
  const { page } = await room.atDesk('Anna');
  await beforeWorkers(page, LOST_CONTEXT);
  await page.goto('/examples/image-processing');
  // Of the clip, the cup would be back a quarter of a minute later.
  await showPhoto(page, 'coffee.jpg');
  await page.getByRole('combobox', { name: 'Module' }).click();
  await page.getByRole('option', { name: /^object-detection/ }).click();
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  const outputs = page.getByRole('region', { name: 'Outputs' });
  const output = (name: string) =>
    outputs
      .getByRole('listitem')
      .filter({ has: page.getByRole('link', { name: `${name} in a new tab`, exact: true }) });
  await expect(output('backend')).toContainText('wasm', { timeout: 30_000 });
  await page.getByRole('combobox', { name: 'backend', exact: true }).selectOption('webgl');
  await expect(output('backendFault')).toContainText(
    'webgl failed during use: The WebGL context was lost. wasm replaces it.',
    { timeout: 120_000 },
  );
  await expect(output('backend')).toContainText('wasm');
  await expect(page.locator('[data-shape="cup"]').first()).toBeAttached();
});

test('WebGL in the worker of a tab finds the keypoints that wasm finds, or leaves them to wasm when it is too slow [PM-90] [PM-97]', async ({
  room,
}) => {
  // MoveNet, because software WebGL takes minutes to compile the programs of the detectors.
  test.slow();
  const robot = await room.program('Robot');
  const anna = await room.atDesk('Anna');
  const name = 'body-pose';
  const { id } = await robot.call('sessionRuntimeStart', {
    name: 'Gymnastics',
    processingModules: [{ name }],
    ioMappings: [
      {
        processingModuleName: name,
        inputMappings: [
          { inputName: 'image', topic: '/gym/image' },
          { inputName: 'backend', topic: '/gym/wanted' },
        ],
        outputMappings: [
          { outputName: 'keypoints', topic: '/gym/keypoints' },
          { outputName: 'backend', topic: '/gym/backend' },
          { outputName: 'backendFault', topic: '/gym/fault' },
        ],
      },
    ],
  });
  let backend = '';
  robot.subscribe('/gym/backend', { format: 'string' }).onRecord(({ value }) => {
    backend = value;
  });
  let fault = '';
  robot.subscribe('/gym/fault', { format: 'string' }).onRecord(({ value }) => {
    fault = value;
  });
  let keypoints: Object2DList | undefined;
  robot.subscribe('/gym/keypoints', { format: 'object2DList' }).onRecord(({ value }) => {
    keypoints = value;
  });
  const data = new Uint8Array(readFileSync(PHOTO));
  const publishing = setInterval(() => {
    robot.publish('/gym/image', 'image2D', { width: 0, height: 0, dataFormat: 0, data });
  }, 500);
  const found = async (): Promise<Map<string, { x: number; y: number }>> => {
    keypoints = undefined;
    await expect.poll(() => keypoints?.elements.length ?? 0).toBeGreaterThan(4);
    return new Map(
      keypoints!.elements.map(({ id: keypoint, pose }) => [keypoint, pose!.position!]),
    );
  };

  try {
    const session = new SessionPage(anna);
    await anna.page.goto(`/sessions/${id}`);
    await session.place(name, /^This tab/);
    await expect.poll(() => backend).toBe('wasm');
    const wasm = await found();
    robot.publish('/gym/wanted', 'string', 'webgl');
    // On a slow processor, software WebGL takes longer for its first picture than a call may last.
    const isTooSlow = (): boolean => /^webgl is not tried again.* wasm replaces it\.$/.test(fault);
    await expect.poll(() => backend === 'webgl' || isTooSlow(), { timeout: 120_000 }).toBe(true);
    if (isTooSlow()) expect(backend).toBe('wasm');
    const next = await found();
    expect([...next.keys()]).toEqual([...wasm.keys()]);
    for (const [keypoint, { x, y }] of next) {
      expect(x, `x of ${keypoint}`).toBeCloseTo(wasm.get(keypoint)!.x, 1);
      expect(y, `y of ${keypoint}`).toBeCloseTo(wasm.get(keypoint)!.y, 1);
    }
  } finally {
    clearInterval(publishing);
  }
});
