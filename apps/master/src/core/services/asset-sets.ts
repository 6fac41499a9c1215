import { ADMINS, READERS } from '../access/roles.ts';
import { definer, success } from './define-service.ts';

const define = definer<'assetSets'>();

/** Services on asset sets. Downloads connect to the publisher and write to the disk: they are an admin's. */
export const ASSET_SET_SERVICES = [
  // [EX-57]
  define('assetSetList', {
    roles: READERS,
    async handle({ assetSets }, _payload, { caller }) {
      const sets = await assetSets.list();
      const isAdmin = caller.role === 'admin';
      return { elements: sets.map((set) => (isAdmin ? set : { ...set, folder: '' })) };
    },
  }),
  // [EX-58]
  define('assetSetDownload', {
    roles: ADMINS,
    auditObject: (_core, { name }) => name,
    async handle({ assetSets }, { name }) {
      await assetSets.download(name);
      return success(`The asset set ${name} is being downloaded.`);
    },
  }),
  // [EX-58]
  define('assetSetCancel', {
    roles: ADMINS,
    auditObject: (_core, { name }) => name,
    handle({ assetSets }, { name }) {
      assetSets.cancel(name);
      return success(`No download of ${name} is under way.`);
    },
  }),
];
