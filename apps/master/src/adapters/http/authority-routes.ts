import { createHash, X509Certificate } from 'node:crypto';
import type { FastifyInstance } from 'fastify';

/** Gives the authority's certificate as PEM; undefined while the master has none. */
type Authority = () => string | undefined;

/**
 * Serves the authority's certificate to devices that are to trust this master, in each form that some system
 * installs. It is no secret; its key never leaves the data directory. Without an authority the paths are not found.
 */
export function addAuthority(app: FastifyInstance, authority: Authority): void {
  const add = (
    path: string,
    type: string,
    name: string,
    bodyOf: (pem: string) => string | Buffer,
  ): void => {
    app.get(path, (_request, reply) => {
      const pem = authority();
      if (pem === undefined) return reply.callNotFound();
      return reply
        .header('cache-control', 'no-store')
        .header('content-disposition', `attachment; filename="${name}"`)
        .type(type)
        .send(bodyOf(pem));
    });
  };
  // Firefox, Linux and macOS.
  add('/ca.pem', 'application/x-pem-file', 'ubi-interact.pem', (pem) => pem);
  // Android and Windows.
  add('/ca.crt', 'application/x-x509-ca-cert', 'ubi-interact.crt', derOf);
  // iOS and iPadOS.
  add('/ca.mobileconfig', 'application/x-apple-aspen-config', 'ubi-interact.mobileconfig', (pem) =>
    profileOf(derOf(pem), commonNameOf(pem)),
  );
}

/**
 * Serves what a person compares the certificate with on the machine of the master. Empty while there is no
 * authority.
 */
export function addAuthorityFacts(app: FastifyInstance, authority: Authority): void {
  app.get('/ca.json', (_request, reply) => {
    reply.header('cache-control', 'no-store');
    const pem = authority();
    if (pem === undefined) return reply.send({});
    const { fingerprint256, validTo } = new X509Certificate(pem);
    return reply.send({
      name: commonNameOf(pem),
      fingerprint: fingerprint256,
      validToMs: Date.parse(validTo),
    });
  });
}

function derOf(pem: string): Buffer {
  return new X509Certificate(pem).raw;
}

function commonNameOf(authority: string): string {
  return /^CN=(.*)$/m.exec(new X509Certificate(authority).subject)?.[1] ?? 'Ubi-Interact';
}

/**
 * A configuration profile with one root certificate.
 * https://developer.apple.com/documentation/devicemanagement/certificateroot
 */
function profileOf(der: Buffer, name: string): string {
  const title = escapeXml(name);
  const certificate = payload({
    PayloadType: 'com.apple.security.root',
    PayloadIdentifier: 'ubi-interact.authority.certificate',
    PayloadUUID: uuidOf(der, 'certificate'),
    PayloadDisplayName: title,
    PayloadCertificateFileName: 'ubi-interact.crt',
  });
  const profile = payload({
    PayloadType: 'Configuration',
    PayloadIdentifier: 'ubi-interact.authority',
    PayloadUUID: uuidOf(der, 'profile'),
    PayloadDisplayName: title,
    PayloadDescription: 'Lets this device trust the pages of this Ubi-Interact master.',
  });
  return `<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE plist PUBLIC "-//Apple//DTD PLIST 1.0//EN" "http://www.apple.com/DTDs/PropertyList-1.0.dtd">
<plist version="1.0"><dict>
${profile}
<key>PayloadContent</key><array><dict>
${certificate}
<key>PayloadContent</key><data>${der.toString('base64')}</data>
</dict></array>
</dict></plist>
`;
}

function payload(texts: Readonly<Record<string, string>>): string {
  const members = Object.entries(texts).map(
    ([key, text]) => `<key>${key}</key><string>${text}</string>`,
  );
  return [...members, '<key>PayloadVersion</key><integer>1</integer>'].join('\n');
}

/** The same for the same certificate: installing it again replaces it. */
function uuidOf(der: Buffer, part: string): string {
  const hex = createHash('sha256').update(der).update(part).digest('hex').toUpperCase();
  return hex.replace(/^(.{8})(.{4}).(.{3}).(.{3})(.{12}).*$/, '$1-$2-4$3-8$4-$5');
}

function escapeXml(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
