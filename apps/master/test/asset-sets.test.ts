import { AccessRole, AssetSetState, type AssetSet } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { joinAs } from './access-world.ts';

const LIST = '/services/ubii/asset_set_list';
const DOWNLOAD = '/services/ubii/asset_set_download';
const CANCEL = '/services/ubii/asset_set_cancel';
const { ACCESS_ROLE_ADMIN, ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER, ACCESS_ROLE_VIEWER } =
  AccessRole;

const SET: AssetSet = {
  name: 'coco-ssd',
  description: '',
  version: '',
  licence: '',
  source: '',
  problem: '',
  bytes: 5,
  files: 1,
  bundled: false,
  address: 'https://example.org/',
  publisherAddress: 'https://example.org/',
  state: AssetSetState.ASSET_SET_STATE_MISSING,
  folder: '/secret/path',
  download: { running: true, loadedBytes: 2, totalBytes: 5, elapsedMs: 10, error: '' },
};
const assetSetRequest = { name: 'coco-ssd' };

function masterWithSet(): TestMaster {
  const master = new TestMaster();
  master.assetSets.sets = [SET];
  return master;
}

describe('asset sets as services', () => {
  it('[EX-57] are listed for admins, with their folders', async () => {
    const { assetSetList } = await masterWithSet().call({ topic: LIST });
    expect(assetSetList!.elements).toEqual([SET]);
  });

  it.each([ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_VIEWER])(
    '[EX-57] are listed for role %s, progress included, without folders',
    async (role) => {
      const client = await joinAs(masterWithSet(), role);
      const { assetSetList } = await client.call({ topic: LIST });
      expect(assetSetList!.elements).toEqual([{ ...SET, folder: '' }]);
    },
  );

  it('[EX-57] are not listed for players', async () => {
    const player = await joinAs(masterWithSet(), ACCESS_ROLE_PLAYER);
    expect((await player.call({ topic: LIST })).error?.code).toBe('permission_denied');
  });

  it('[EX-58] are downloaded for an admin, who can cancel; the audit log has both', async () => {
    const master = masterWithSet();
    const admin = await joinAs(master, ACCESS_ROLE_ADMIN);
    expect((await admin.call({ topic: DOWNLOAD, assetSetRequest })).success).toBeDefined();
    expect([...master.assetSets.running]).toEqual(['coco-ssd']);
    expect((await admin.call({ topic: CANCEL, assetSetRequest })).success).toBeDefined();
    expect([...master.assetSets.running]).toEqual([]);
    const { auditLog } = await master.call({
      topic: '/services/ubii/audit_log',
      auditLogRequest: { count: 2 },
    });
    expect(auditLog!.entries).toMatchObject([
      { service: CANCEL, object: 'coco-ssd', error: '' },
      { service: DOWNLOAD, object: 'coco-ssd', error: '' },
    ]);
  });

  it.each([ACCESS_ROLE_PARTICIPANT, ACCESS_ROLE_PLAYER, ACCESS_ROLE_VIEWER])(
    '[EX-58] are not downloaded or cancelled for role %s',
    async (role) => {
      const master = masterWithSet();
      const client = await joinAs(master, role);
      const tried = await client.call({ topic: DOWNLOAD, assetSetRequest });
      expect(tried.error?.code).toBe('permission_denied');
      expect(master.assetSets.running.size).toBe(0);
      await master.assetSets.download('coco-ssd');
      const cancelled = await client.call({ topic: CANCEL, assetSetRequest });
      expect(cancelled.error?.code).toBe('permission_denied');
      expect(master.assetSets.running.size).toBe(1);
    },
  );
});
