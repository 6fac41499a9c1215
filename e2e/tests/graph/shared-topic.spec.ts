import type { MasterProcess } from '@ubii/harness';
import { SERVICES } from '@ubii/proto';
import { callService } from '../../fixtures/call-service.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

/** A clock that writes a topic. */
async function aWriter(master: MasterProcess, name: string): Promise<string> {
  const { session } = await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeAdd.topic,
    session: {
      name,
      processingModules: [{ id: crypto.randomUUID(), name: 'clock' }],
    },
  });
  const [module] = session!.processingModules;
  await callService(master.endpoints, {
    topic: SERVICES.sessionRuntimeUpdate.topic,
    session: {
      ...session!,
      ioMappings: [
        {
          processingModuleId: module!.id,
          outputMappings: [{ outputName: 'sine', topic: '/both/sine' }],
        },
      ],
    },
  });
  return session!.id;
}

test('two sessions that write one topic name each other, where it is and in the list', async ({
  room,
  master,
}) => {
  const { page } = await room.atDesk('Anna');
  const [first, second] = [await aWriter(master, 'First'), await aWriter(master, 'Second')];
  const start = (id: string) =>
    callService(master.endpoints, {
      topic: SERVICES.sessionRuntimeStart.topic,
      session: { id },
    });
  await start(first);
  const graph = new GraphPage({ page });

  await test.step('before it is started, too: the topic says who writes it', async () => {
    await graph.open(second);
    const mark = graph.problems('Topic /both/sine');
    await expect(mark).toHaveAccessibleName(
      /The session "First" runs and writes \/both\/sine, too/,
    );
    await expect(page.getByRole('button', { name: '1 problem', exact: true })).toBeVisible();
    await mark.click();
    await page.getByRole('link', { name: 'Open First' }).click();
    await expect(graph.title).toContainText('First');
  });

  await test.step('once both run, it is said in both, and goes when one stops', async () => {
    await expect(graph.node('Topic /both/sine')).toBeVisible();
    await expect(graph.problems('Topic /both/sine')).toBeHidden();
    await start(second);
    await expect(graph.problems('Topic /both/sine')).toHaveAccessibleName(/"Second"/);
  });

  await test.step('the list of sessions says so, and leads there', async () => {
    await page.goto('/sessions');
    const row = page.getByRole('listitem').filter({ hasText: 'Writes /both/sine' });
    await expect(row).toHaveCount(2);
    await row.getByRole('link', { name: 'Second' }).last().click();
    const problems = page.getByRole('list', { name: 'Problems', exact: true });
    await page.getByRole('button', { name: 'Log', exact: true }).click();
    await expect(problems).toContainText('The session "First" runs and writes /both/sine, too');
    await callService(master.endpoints, {
      topic: SERVICES.sessionRuntimeStop.topic,
      session: { id: first },
    });
    await expect(problems).toBeHidden();
  });

  await test.step('one click gives the session a topic of its own', async () => {
    await start(first);
    await graph.open(second);
    await graph.problems('Topic /both/sine').click();
    await page.getByRole('button', { name: 'Use topics of its own' }).click();
    await expect(graph.node('Topic /Second/sine')).toBeVisible();
    await page.goto('/sessions');
    await expect(page.getByRole('listitem').filter({ hasText: 'Second' }).first()).toBeVisible();
    await expect(page.getByRole('listitem').filter({ hasText: 'Writes /both/sine' })).toHaveCount(
      0,
    );
  });
});
