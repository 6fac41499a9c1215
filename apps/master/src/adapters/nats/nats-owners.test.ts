import { ownerStoreSuite } from '../../testing/acceptance/index.ts';
import { openNatsBench, type CuttableLink } from '../../testing/nats-bench.ts';
import { NatsOwners } from './nats-owners.ts';

ownerStoreSuite('NatsOwners', async () => {
  const bench = await openNatsBench();
  const links: CuttableLink[] = [];
  return {
    async open() {
      const opened = await bench.openLink();
      links.push(opened);
      return NatsOwners.open(opened.link, 'ubii_test_owners');
    },
    async setFirstReachable(isReachable) {
      const [{ link, cut, heal }] = links as [CuttableLink];
      if (isReachable) return heal();
      const lost = new Promise<void>((resolve) => link.onReach(() => resolve()));
      cut();
      await lost;
    },
    close: () => bench.close(),
  };
});
