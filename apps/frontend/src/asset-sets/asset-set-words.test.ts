import { AssetSetState } from '@ubii/proto';
import { expect, it } from 'vitest';
import { assetSetLook, downloadWords, megabytes } from './asset-set-words.ts';

const download = { running: true, totalBytes: 18_561_843, error: '' };

it('a size is in megabytes', () => {
  expect(megabytes(18_561_843)).toBe('18.6 MB');
});

it('a download says bytes of bytes, and the time left once something has come', () => {
  expect(downloadWords({ ...download, loadedBytes: 0, elapsedMs: 400 })).toBe('0.0 of 18.6 MB');
  expect(downloadWords({ ...download, loadedBytes: 9_280_000, elapsedMs: 12_000 })).toBe(
    '9.3 of 18.6 MB, 12 s left',
  );
  expect(downloadWords({ ...download, loadedBytes: 185_618, elapsedMs: 2000 })).toBe(
    '0.2 of 18.6 MB, 3 min left',
  );
});

it('a set that comes with the program is no set that was installed', () => {
  const state = AssetSetState.ASSET_SET_STATE_PRESENT;
  expect(assetSetLook({ state, bundled: true }).word).toBe('Included');
  expect(assetSetLook({ state, bundled: false }).word).toBe('Installed');
});
