import { meet, DESKTOP } from '../../fixtures/person.ts';
import { expect, test } from '../../fixtures/test.ts';
import { startWatchedBrowser } from '../../fixtures/foreign-traffic.ts';
import { showPhoto } from '../../pages/picture-source.ts';

test('no vision module asks another host for anything, in pages, workers and service workers', async ({
  master,
}) => {
  const { browser, asked, close } = await startWatchedBrowser();
  try {
    const { page, context, watch } = await meet(browser, master.url, 'Anna', DESKTOP);
    const main = page.getByRole('main');

    await test.step('objects, bodies and hands in this tab', async () => {
      await page.goto('/examples/object-detection');
      await showPhoto(page, 'astronaut.jpg');
      await page.getByRole('switch', { name: /^Body/ }).click();
      await page.getByRole('switch', { name: /^Hands/ }).click();
      await page.getByRole('button', { name: 'Start', exact: true }).click();
      await expect(main).toContainText(/Live| s old/);
      await expect(page.locator('[data-bone]').first()).toBeAttached();
      expect(watch.findings).toEqual([]);
    });

    await test.step('every other module that takes pictures', async () => {
      await page.goto('/examples/image-processing');
      await showPhoto(page, 'astronaut.jpg');
      const module = page.getByRole('combobox', { name: 'Module', exact: true });
      await module.click();
      await expect(page.getByRole('option').nth(3)).toBeVisible();
      const names = await page.getByRole('option').allInnerTexts();
      await page.keyboard.press('Escape');
      await page.getByRole('button', { name: 'Start', exact: true }).click();
      const outputs = page.getByRole('region', { name: 'Outputs' });
      for (const name of names) {
        await module.click();
        await page
          .getByRole('option', { name: name.split('\n')[0]! })
          .first()
          .click();
        await expect(outputs.locator('span[title]:not([title="–"])').first()).toBeVisible();
      }
    });

    await test.step('the counter counts', async () => {
      expect(asked).toEqual([]);
      const other = await context.newPage();
      await other.goto('http://elsewhere.example/model.json').catch(() => undefined);
      expect(asked).toEqual(['GET http://elsewhere.example/model.json HTTP/1.1']);
    });
  } finally {
    await close();
  }
});
