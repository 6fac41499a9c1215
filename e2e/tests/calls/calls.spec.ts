import { expect, test } from '../../fixtures/test.ts';
import { Shell } from '../../pages/shell.ts';

test('services are called', async ({ room }) => {
  const robot = await room.program('Robot');
  const { page } = await room.atDesk();
  const service = page.getByRole('article', { name: /^Service/ });

  await test.step('a service is found, called from its form, and its reply read', async () => {
    await page.goto('/calls');
    await new Shell(page).expectConnected();
    await page.getByRole('searchbox', { name: 'Search services' }).fill('clients profiles');
    await page.getByRole('link', { name: /client\/get_list/ }).click();
    await expect(service).toContainText('ubii.clients.ClientList');
    await service.getByRole('button', { name: 'Call', exact: true }).click();
    const reply = service.getByRole('list', { name: 'Reply' });
    await expect(reply).toContainText('elements');
    await service.getByRole('switch', { name: 'With a request' }).click();
    await service.getByRole('button', { name: 'Add to elements' }).click();
    await service.getByRole('textbox', { name: 'id', exact: true }).fill(robot.id);
    await service.getByRole('button', { name: 'Call', exact: true }).click();
    await expect(reply).toContainText('[1]');
    await expect(page.getByRole('list', { name: 'Calls' }).getByRole('listitem')).toHaveCount(2);
  });

  await test.step('a call that fails says why, and is there again in the history', async () => {
    await page.goto('/calls/deviceGet');
    await new Shell(page).expectConnected();
    await service.getByRole('radio', { name: 'JSON' }).click();
    const json = service.getByRole('textbox', { name: 'Request as JSON' });
    await json.fill('{"id": "nobody"}');
    await service.getByRole('button', { name: 'Call', exact: true }).click();
    await expect(service).toContainText('not_found');
    await page.getByRole('link', { name: /^topic_list/ }).click();
    await service.getByRole('button', { name: 'Call', exact: true }).click();
    await expect(service.getByRole('list', { name: 'Reply' })).toContainText('/services/');
    await page
      .getByRole('list', { name: 'Calls' })
      .getByRole('button', { name: /device\/get/ })
      .click();
    await expect(service).toHaveAccessibleName('Service /services/device/get');
    await expect(service).toContainText('not_found');
    await service.getByRole('radio', { name: 'JSON' }).click();
    await expect(json).toHaveValue(/nobody/);
  });

  await test.step('a request that cannot be read is not sent', async () => {
    const { page: phone } = await room.withPhone();
    await phone.goto('/calls/deviceGet');
    const shell = new Shell(phone);
    await shell.expectConnected();
    const onPhone = phone.getByRole('article', { name: /^Service/ });
    await onPhone.getByRole('radio', { name: 'JSON' }).click();
    await onPhone.getByRole('textbox', { name: 'Request as JSON' }).fill('{"nam": 1}');
    await expect(
      onPhone.getByRole('button', { name: /Line 1 nam is not known here/ }),
    ).toBeVisible();
    await expect(onPhone.getByRole('button', { name: 'Call', exact: true })).toHaveAttribute(
      'aria-disabled',
      'true',
    );
    expect(await shell.overflowPx()).toBe(0);
  });
});
