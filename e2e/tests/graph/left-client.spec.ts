import { placedSession } from '../../fixtures/placed-session.ts';
import { expect, test } from '../../fixtures/test.ts';
import { GraphPage } from '../../pages/graph-page.ts';

const GONE = 'b0c47f3b-1111-4222-8333-444455556666';

test('a topic of a client that has left is replaced by that of another client with one button', async ({
  master,
  room,
}) => {
  const robot = await room.program('Robot');
  robot.publish(`/${robot.id}/arm/angle`, 'double', 1.5);
  const id = await placedSession(master, {
    reader: { x: 400, y: 200, reads: `/${GONE}/arm/angle` },
  });
  const { page } = await room.atDesk('Anna');
  const graph = new GraphPage({ page });
  await graph.open(id);
  const problems = page.getByRole('button', { name: '1 problem', exact: true });
  await problems.click();
  const list = page.getByRole('dialog', { name: '1 problem' });
  await expect(list).toContainText(
    'Topic "arm/angle" has no value: its client Client b0c47f3b has left. Robot publishes the same topic.',
  );
  await list.getByRole('button', { name: 'Use angle of Robot' }).click();
  await expect(problems).toBeHidden();
  await expect(graph.life.getByRole('button', { name: /1 change/ })).toBeVisible();
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(problems).toBeVisible();
  await page.getByRole('button', { name: 'Redo' }).click();
  await expect(problems).toBeHidden();
});
