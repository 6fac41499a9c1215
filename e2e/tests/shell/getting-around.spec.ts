import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';
import { NAVIGATION_PAGES } from './navigation-pages.ts';

test('pages are reached by navigation, address and keyboard', async ({ room }) => {
  const { page } = await room.atDesk();
  await page.goto('/');
  const shell = new Shell(page);

  await test.step('every page of the navigation can be reached, and gone back from', async () => {
    for (const [name, path] of NAVIGATION_PAGES) {
      await shell.go(name);
      await expect(page).toHaveURL((url) => url.pathname === path);
      await expect(page).toHaveTitle(new RegExp(`^${name}`));
    }
    await page.goBack();
    await expect(page).toHaveURL(/\/settings$/);
  });

  await test.step('an unknown address says so and leads home', async () => {
    await page.goto('/sessions/of/another/version');
    await expect(page.getByRole('heading', { level: 1 })).toHaveText('Page not found');
    await expect(page.getByText('/sessions/of/another/version')).toBeVisible();
    await page.getByRole('main').getByRole('link', { name: 'Home' }).click();
    await expect(page).toHaveURL((url) => url.pathname === '/');
  });

  await test.step('the connection and its round trip are always in sight', async () => {
    for (const person of [{ page }, await room.withPhone()]) {
      await person.page.goto('/topics');
      await expect(new Shell(person.page).connection).toContainText(/\d+(\.\d+)?\s*ms/);
    }
  });

  await test.step('everything can be reached with the keyboard alone', async () => {
    await page.goto('/');
    await shell.expectConnected();

    await test.step('the first stop jumps over the navigation', async () => {
      await page.keyboard.press('Tab');
      await expect(page.getByRole('link', { name: 'Skip to the content' })).toBeFocused();
      await page.keyboard.press('Enter');
      await expect(shell.main).toBeFocused();
    });

    await test.step('tabbing through the page comes by every control, always in sight', async () => {
      await page.goto('/examples/mouse-pointer');
      await shell.expectConnected();
      await expect(page.getByRole('application')).toBeVisible();
      const seen = new Set<string>();
      for (let press = 0; press < 40; press++) {
        await page.keyboard.press('Tab');
        const focused = await page.evaluate(() => {
          const element = document.activeElement;
          if (!element || element === document.body) return undefined;
          const { outlineStyle, boxShadow } = getComputedStyle(element);
          const { width, height } = element.getBoundingClientRect();
          const name = element.getAttribute('aria-label') ?? element.textContent?.trim() ?? '';
          const marked = outlineStyle !== 'none' || boxShadow !== 'none';
          return { name, role: element.role ?? element.tagName, marked, drawn: width * height > 0 };
        });
        if (!focused) continue;
        seen.add(focused.name);
        expect(focused.marked, `focus is visible on ${focused.role} "${focused.name}"`).toBe(true);
        expect(focused.drawn, `${focused.role} "${focused.name}" is drawn`).toBe(true);
      }
      expect([...seen]).toEqual(
        expect.arrayContaining(['Pointer pad', 'Publish interval', 'Topics', 'Connect a phone']),
      );
    });

    await test.step('pairs of keys go to pages', async () => {
      await page.keyboard.press('g');
      await page.keyboard.press('m');
      await expect(page).toHaveURL(/\/modules$/);
      // There the keyboard goes on.
      await expect(page.getByRole('heading', { level: 1 })).toBeFocused();
    });
  });
});

test('where no phone can reach the master, a phone opens in this browser', async ({
  master,
  room,
}) => {
  const { page, context } = await room.atDesk('Ben');
  await page.goto('/');
  await new Shell(page).button('Connect a phone').click();
  const dialog = page.getByRole('dialog');
  // This master listens on loopback only: no code would work, so no invitation is created.
  await expect(dialog.getByRole('button', { name: 'Turn on the local network' })).toBeVisible();
  await expect(dialog.locator('[data-join-code]')).toHaveCount(0);

  const opened = context.waitForEvent('page');
  await dialog.getByRole('button', { name: 'Open a phone in this browser' }).click();
  const phone = await opened;
  await expect(phone).toHaveURL(/\/devices\/smart-device$/);
  await test.step('the dialog says who joined', async () => {
    await expect(dialog.getByText('Ben 2 joined')).toBeVisible();
    await expect(dialog.getByText('Ben joined')).toHaveCount(0);
  });
  await page.keyboard.press('Escape');
  await expect(dialog).toBeHidden();

  await test.step('it is a client of its own, with a name of its own', async () => {
    const clients = page.getByRole('list', { name: 'Here' });
    await expect(clients.getByRole('link', { name: 'Ben 2', exact: true })).toBeVisible();
    await expect(clients.getByRole('link', { name: 'Ben', exact: true })).toBeVisible();
    await expect(phone.getByRole('button', { name: 'Change your name' })).toContainText('Ben 2');
  });
  const { accessGrantList } = await callService(master.endpoints, {
    topic: '/services/ubii/access_grant_list',
  });
  expect(accessGrantList!.elements.filter(({ isTerminal }) => !isTerminal)).toEqual([]);
});
