import { createReadStream } from 'node:fs';
import type { FastifyInstance, FastifyRequest } from 'fastify';
import { AssetError, ASSETS_PATH, type AssetErrorCode } from '@ubii/pm-sandbox';
import type { AssetFolders } from '@ubii/pm-sandbox/node';
import { ServiceError, type ServiceErrorCode } from '@ubii/proto';

const ONE_YEAR = 'public, max-age=31536000, immutable';
const CODES: Readonly<Record<AssetErrorCode, ServiceErrorCode>> = {
  missing: 'not_found',
  damaged: 'failed_precondition',
  unreachable: 'unavailable',
};

/** Serves asset sets: the manifest of each, and its files under their hash. [PM-92] */
export function addAssets(app: FastifyInstance, assets: AssetFolders): void {
  app.get(`${ASSETS_PATH}/:name/manifest.json`, async (request, reply) => {
    const { name } = paramsOf(request);
    const manifest = await orServiceError(assets.manifest(name));
    return reply.header('cache-control', 'no-cache').send(manifest);
  });
  app.get(`${ASSETS_PATH}/:name/:hash/*`, async (request, reply) => {
    const { name, hash, '*': path } = paramsOf(request);
    const { files } = await orServiceError(assets.manifest(name));
    const file = files.find((one) => one.path === path && one.sha256 === hash);
    if (file === undefined)
      throw new ServiceError('not_found', `The asset set ${name} has no such file.`);
    // Caches keep it permanently: what was damaged would stay so after it was repaired.
    const full = await orServiceError(assets.verify(name, file));
    return reply
      .header('cache-control', ONE_YEAR)
      .header('content-length', file.bytes)
      .header('x-content-type-options', 'nosniff')
      .header('content-security-policy', "default-src 'none'")
      .type('application/octet-stream')
      .send(createReadStream(full));
  });
}

interface AssetParams {
  readonly name: string;
  readonly hash: string;
  readonly '*': string;
}

const paramsOf = ({ params }: FastifyRequest): AssetParams => params as AssetParams;

async function orServiceError<T>(asked: Promise<T>): Promise<T> {
  try {
    return await asked;
  } catch (cause) {
    if (cause instanceof AssetError) throw new ServiceError(CODES[cause.code], cause.message);
    throw cause;
  }
}
