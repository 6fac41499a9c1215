import { join } from 'node:path';
import type { Page } from '@playwright/test';

const PHOTOS = join(import.meta.dirname, '../../packages/vision/photos');

/**
 * Has an example look at a photograph in place of its clip. It is sent twice a second, the clip as often as modules keep
 * up with it: what a story waits for does not take the time of its modules.
 *
 * @param file of the photographs of the vision package
 */
export async function showPhoto(page: Page, file: string): Promise<void> {
  await page.getByRole('radio', { name: 'File' }).click();
  await page.locator('input[type=file]').setInputFiles(join(PHOTOS, file));
}
