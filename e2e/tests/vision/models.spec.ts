import { existsSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { MasterProcess } from '@ubii/harness';
import { squares, tinyCocoSsd } from '@ubii/vision/testing/coco-ssd';
import { pngOf } from '@ubii/vision/testing/png';
import type { Locator } from '@playwright/test';
import { FakeMirror } from '../../fixtures/fake-mirror.ts';
import type { Person } from '../../fixtures/person.ts';
import { endMaster, startMaster } from '../../fixtures/start-master.ts';
import { expect, test as base } from '../../fixtures/test.ts';

const PAGE = '/examples/object-detection';
const GET = 'Download the model (18.6 MB)';

interface Fixtures {
  readonly mirror: FakeMirror;
}

/** A master that downloads models from a mirror. */
const test = base.extend<Fixtures>({
  // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of fixtures from here
  mirror: async ({}, use) => {
    const mirror = await FakeMirror.start();
    await use(mirror);
    await mirror.close();
  },
  master: async ({ mirror }, use) => {
    const master = await startMaster({ flags: ['--model-mirror', mirror.url] });
    await use(master);
    const { failures } = master;
    await endMaster(master);
    expect(failures, 'lines in the log of the master that say something broke').toEqual([]);
  },
});

const button = ({ page }: Person, name: string): Locator =>
  page.getByRole('button', { name, exact: true });

async function chooseDetector({ page }: Person, name: string): Promise<void> {
  await page.getByRole('combobox', { name: 'Detector' }).click();
  await page.getByRole('option', { name }).click();
}

/** Puts a model into the data directory, as a person would. */
function install(master: MasterProcess, name: string, files: Record<string, Uint8Array>): void {
  const folder = join(master.dataDir, 'models', name);
  mkdirSync(folder, { recursive: true });
  for (const [file, bytes] of Object.entries(files)) writeFileSync(join(folder, file), bytes);
}

test('an admin gets the model of a detector, cancels, and sees why it cannot be downloaded [EX-58]', async ({
  room,
  master,
  mirror,
}) => {
  const anna = await room.atDesk('Anna');
  const { page } = anna;
  const models = join(master.dataDir, 'models');
  await page.goto(PAGE);
  await chooseDetector(anna, 'COCO-SSD');
  await expect(page.getByRole('main')).toContainText('The model of COCO-SSD is not installed.');

  await test.step('the download shows how far it is, and can be cancelled', async () => {
    mirror.answer = (response) => void response.writeHead(200).write(Buffer.alloc(100_000));
    await button(anna, GET).click();
    await expect(page.getByRole('progressbar')).toHaveAttribute('value', '100000');
    await expect(page.getByRole('main')).toContainText(/0\.1 of 18\.6 MB, .+ left/);
    await button(anna, 'Cancel').click();
    await expect(button(anna, GET)).toBeVisible();
    expect(readdirSync(models)).toEqual([]);
  });

  await test.step('a mirror that has other files is refused', async () => {
    mirror.answer = (response) => void response.writeHead(200).end(Buffer.alloc(527_315));
    await button(anna, GET).click();
    const alert = page.getByRole('alert').filter({ hasText: 'its SHA-256 differs' });
    await expect(alert).toContainText(`${mirror.url.slice(0, -1)} sent a file that differs`);
    await expect(alert).toContainText('download the files from https://storage.googleapis.com/');
    await expect(alert).toContainText(join(models, 'coco-ssd'));
    expect(existsSync(join(models, 'coco-ssd'))).toBe(false);
  });

  await test.step('so is one that cannot be reached', async () => {
    await mirror.close();
    await button(anna, GET).click();
    await expect(page.getByRole('alert')).toContainText('could not be reached');
  });

  await test.step('the audit log has it', async () => {
    await page.goto('/settings/audit');
    await expect(page.getByRole('main')).toContainText(
      'cancelled the download of the model coco-ssd',
    );
  });
});

test('a participant sees who can download the model [EX-58]', async ({ browser }) => {
  const master = await startMaster({ trustsLoopback: false });
  const page = await browser.newPage({ baseURL: master.url });
  try {
    await page.goto(`${PAGE}`);
    await page.getByRole('combobox', { name: 'Detector' }).click();
    await page.getByRole('option', { name: 'COCO-SSD' }).click();
    await expect(page.getByRole('main')).toContainText(
      'An admin of this master can download the model (18.6 MB).',
    );
    await expect(page.getByRole('button', { name: GET })).toHaveCount(0);
  } finally {
    await page.close();
    await endMaster(master);
  }
});

test('the detector is changed while it runs, with a model that was put there by hand [PM-96]', async ({
  room,
  master,
}) => {
  const anna = await room.atDesk('Anna');
  const { page } = anna;
  const seen = page.getByRole('region', { name: /^Detected now/ });
  const photo = join(master.dataDir, 'red.png');
  // A person for the tiny model, and nothing for CenterNet.
  writeFileSync(photo, pngOf(squares({ x: 160, y: 120, rgb: [255, 0, 0] })));
  await page.goto(PAGE);
  await page.getByRole('radio', { name: 'File' }).click();
  await page.locator('input[type=file]').setInputFiles(photo);
  await page.getByRole('button', { name: 'Start', exact: true }).click();
  await expect(page.getByRole('main')).toContainText(/Live| s old/);
  await expect(seen).toContainText('Nothing above the threshold');

  await test.step('without the model, CenterNet goes on', async () => {
    // The module looks for it again and again.
    anna.watch.expect(/404 .*asset-sets\/coco-ssd\/manifest\.json/);
    await chooseDetector(anna, 'COCO-SSD');
    await expect(button(anna, GET)).toBeVisible();
    await expect(seen).toContainText('Nothing above the threshold');
  });

  await test.step('with the model, which arrives while the module runs', async () => {
    install(master, 'coco-ssd', tinyCocoSsd());
    await expect(button(anna, GET)).toHaveCount(0);
    await expect(seen).toContainText('person');
    await expect(page.getByRole('main')).toContainText('person');
  });

  await test.step('on the master as well', async () => {
    await page
      .getByRole('radiogroup', { name: 'Node that runs the modules' })
      .getByRole('radio', { name: /^Master/ })
      .click();
    // Until it runs there, with CenterNet before the other model is read.
    await expect(seen).not.toContainText('person');
    await expect(seen).toContainText('person');
  });

  await test.step('and back to CenterNet', async () => {
    await chooseDetector(anna, 'CenterNet');
    await expect(seen).toContainText('Nothing above the threshold');
  });

  await test.step('the page of the module says that it is installed', async () => {
    await page.goto('/modules/object-detection');
    const row = page.getByRole('listitem', { name: 'coco-ssd', exact: true });
    await expect(row).toContainText('Installed');
    await expect(page.getByRole('listitem', { name: 'tfjs-wasm' })).toContainText('Included');
  });
});
