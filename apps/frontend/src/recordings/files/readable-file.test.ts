// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { CONNECTION } from '../../connection/connection.ts';
import { createToasts, provideToasts } from '../../ui/toasts/toasts.ts';
import { uploadRecording } from '../list/upload-recording.ts';
import DownloadLink from './DownloadLink.vue';
import { openSource } from './open-source.ts';
import { masterFile } from './readable-file.ts';

const INVITED = { authorization: 'Bearer u1.credential' };
const BYTES = new Uint8Array([1, 2, 3, 4]);

/** A master that sends files to clients with the credential only. [AC-21] */
function guardedMaster() {
  const requests: string[] = [];
  vi.stubGlobal('fetch', async (url: string, init: RequestInit = {}) => {
    const headers = new Headers(init.headers);
    requests.push(`${init.method ?? 'GET'} ${url} ${headers.get('Range') ?? ''}`.trim());
    if (headers.get('Authorization') !== INVITED.authorization)
      return new Response(null, { status: 401, statusText: 'Unauthorized' });
    if (init.method === 'POST') return Response.json({ id: 'new' });
    const facts = { ETag: '"1"', 'Content-Length': String(BYTES.length) };
    return new Response(init.method === 'HEAD' ? null : BYTES, {
      status: headers.has('Range') ? 206 : 200,
      headers: facts,
    });
  });
  return requests;
}

afterEach(() => {
  vi.restoreAllMocks();
  vi.unstubAllGlobals();
});

describe('a client that joined with an invitation', () => {
  it('reads recordings of the master with its credential [AC-13] [RC-40]', async () => {
    const requests = guardedMaster();
    const source = openSource(masterFile('a b', INVITED));
    expect(await source.read(1n, 2n)).toEqual(BYTES.slice(1, 3));
    expect(requests).toEqual([
      'HEAD /recordings/a%20b.mcap',
      'GET /recordings/a%20b.mcap bytes=0-3',
    ]);
    const stranger = openSource(masterFile('a', { authorization: undefined }));
    await expect(stranger.size()).rejects.toThrow('The master answered 401 Unauthorized.');
  });

  it('reads and writes them at the master that it moved to [CU-92]', async () => {
    const requests = guardedMaster();
    const client = { ...INVITED, masterUrl: 'http://10.0.0.6:8080' };
    expect(await openSource(masterFile('a', client)).read(1n, 2n)).toEqual(BYTES.slice(1, 3));
    await uploadRecording(new File([BYTES], 'b.mcap'), client);
    expect(requests.map((each) => each.split(' ')[1])).toEqual([
      'http://10.0.0.6:8080/recordings/a.mcap',
      'http://10.0.0.6:8080/recordings/a.mcap',
      'http://10.0.0.6:8080/recordings?name=b',
    ]);
  });

  it('uploads recordings with its credential [RC-41]', async () => {
    guardedMaster();
    const uploaded = await uploadRecording(new File([BYTES], 'b.mcap'), INVITED);
    expect(uploaded.id).toBe('new');
  });
});

describe('the link that downloads a recording', () => {
  function link(client: { readonly authorization: string | undefined }) {
    const toasts = createToasts();
    const wrapper = mount(DownloadLink, {
      props: { recordingId: 'a', name: 'Study', label: 'Download' },
      global: {
        plugins: [{ install: (app) => provideToasts(app, toasts) }],
        provide: { [CONNECTION as symbol]: { client } },
      },
    });
    const click = new MouseEvent('click', { cancelable: true });
    return { toasts, wrapper, click };
  }

  it('is an ordinary link for clients without a credential', () => {
    const requests = guardedMaster();
    const { wrapper, click } = link({ authorization: undefined });
    wrapper.element.dispatchEvent(click);
    expect([click.defaultPrevented, requests]).toEqual([false, []]);
  });

  it('saves what it requests with the credential', async () => {
    guardedMaster();
    const saved: string[] = [];
    vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => {
      saved.push(`${(blob as Blob).size} bytes`);
      return 'blob:file';
    });
    vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: {
      download: string;
    }) {
      saved.push(this.download);
    });
    const { wrapper, click } = link(INVITED);
    wrapper.element.dispatchEvent(click);
    await flushPromises();
    expect([click.defaultPrevented, saved]).toEqual([true, ['4 bytes', 'Study.mcap']]);
  });

  it('says why a file was not downloaded', async () => {
    guardedMaster();
    const { wrapper, click, toasts } = link({ authorization: 'Bearer old' });
    wrapper.element.dispatchEvent(click);
    await flushPromises();
    expect(toasts.list.value.map(({ text }) => text)).toEqual([
      'Study was not downloaded. The master answered 401 Unauthorized.',
    ]);
  });
});
