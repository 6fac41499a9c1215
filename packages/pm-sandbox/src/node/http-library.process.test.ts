import { createServer, type RequestListener } from 'node:http';
import type { AddressInfo } from 'node:net';
import { describe, expect, it, onTestFinished } from 'vitest';
import { createHttpLibrary } from './http-library.ts';

async function serve(listener: RequestListener): Promise<string> {
  const server = createServer(listener);
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  onTestFinished(() => {
    server.closeAllConnections();
    server.close();
  });
  return `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
}

describe('the library http', () => {
  it('[PM-52] reads what the operator allows', async () => {
    const origin = await serve((request, response) => {
      response.statusCode = request.url === '/missing' ? 404 : 200;
      response.end(`größer ${request.url}`);
    });
    const { get } = createHttpLibrary([origin]);
    expect(await get!(`${origin}/a?b=1`)).toEqual({ status: 200, text: 'größer /a?b=1' });
    expect(await get!(`${origin}/missing`)).toMatchObject({ status: 404 });
  });

  it('reads nothing else, also when a page that is allowed leads there', async () => {
    const asked: unknown[] = [];
    const other = await serve((request, response) => {
      asked.push(request.url);
      response.end();
    });
    const origin = await serve((request, response) => {
      response.writeHead(302, { location: request.url === '/own' ? '/own' : `${other}/secret` });
      response.end();
    });
    const { get } = createHttpLibrary([origin]);
    await expect(get!(other)).rejects.toThrow('--allow-fetch');
    await expect(get!(`${origin}/away`)).rejects.toThrow(`Reading from ${other} is not allowed`);
    await expect(get!(`${origin}/own`)).rejects.toThrow('more than 5 times');
    await expect(get!('file:///etc/passwd')).rejects.toThrow('is not allowed');
    await expect(get!('nothing')).rejects.toThrow('Expected a URL');
    expect(asked).toEqual([]);
  });

  it('says why there is no answer', async () => {
    const origin = await serve((request, response) => {
      if (request.url === '/large') response.end(Buffer.alloc(2 * 1024 * 1024));
      else request.socket.destroy();
    });
    const { get } = createHttpLibrary([origin]);
    await expect(get!(`${origin}/large`)).rejects.toThrow('more than 1048576 bytes');
    await expect(get!(`${origin}/cut`)).rejects.toThrow(`${origin} cannot be reached`);
  });
});
