import type { ServiceHandler } from './handler.ts';

/** `/services/ubii/asset_set_list` [EX-57] */
export const listAssetSets: ServiceHandler = async ({ assetSets }, _request, { caller }) => {
  const sets = await assetSets.list();
  const isAdmin = caller.role === 'admin';
  return {
    assetSetList: { elements: sets.map((set) => (isAdmin ? set : { ...set, folder: '' })) },
  };
};

/** `/services/ubii/asset_set_download` [EX-58] */
export const downloadAssetSet: ServiceHandler = async ({ assetSets }, { assetSetRequest }) => {
  const { name } = assetSetRequest!;
  await assetSets.download(name);
  return { success: { title: 'Success', message: `The asset set ${name} is being downloaded.` } };
};

/** `/services/ubii/asset_set_cancel` [EX-58] */
export const cancelAssetSet: ServiceHandler = ({ assetSets }, { assetSetRequest }) => {
  const { name } = assetSetRequest!;
  assetSets.cancel(name);
  return { success: { title: 'Success', message: `No download of ${name} is under way.` } };
};
