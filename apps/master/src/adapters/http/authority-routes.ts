import { createHash, X509Certificate } from 'node:crypto';
import type { FastifyInstance, FastifyReply } from 'fastify';

/**
 * The authority's certificate, for devices that are to trust this master: in each form that some system
 * installs. It is no secret; its key never leaves the data directory.
 *
 * @param authority PEM
 */
export function addAuthority(app: FastifyInstance, authority: string): void {
  const der = new X509Certificate(authority).raw;
  const send = (reply: FastifyReply, type: string, name: string, body: string | Buffer): unknown =>
    reply
      .header('cache-control', 'no-store')
      .header('content-disposition', `attachment; filename="${name}"`)
      .type(type)
      .send(body);
  // Firefox, Linux and macOS.
  app.get('/ca.pem', (_request, reply) =>
    send(reply, 'application/x-pem-file', 'ubi-interact.pem', authority),
  );
  // Android and Windows.
  app.get('/ca.crt', (_request, reply) =>
    send(reply, 'application/x-x509-ca-cert', 'ubi-interact.crt', der),
  );
  // iOS and iPadOS.
  app.get('/ca.mobileconfig', (_request, reply) =>
    send(
      reply,
      'application/x-apple-aspen-config',
      'ubi-interact.mobileconfig',
      profileOf(der, commonNameOf(authority)),
    ),
  );
}

/**
 * For the page that helps to install it: what to compare it with on the machine of the master. Empty where
 * there is no authority.
 *
 * @param authority PEM
 */
export function addAuthorityFacts(app: FastifyInstance, authority: string | undefined): void {
  app.get('/ca.json', (_request, reply) => {
    reply.header('cache-control', 'no-store');
    if (authority === undefined) return reply.send({});
    const { fingerprint256, validTo } = new X509Certificate(authority);
    return reply.send({
      name: commonNameOf(authority),
      fingerprint: fingerprint256,
      validToMs: Date.parse(validTo),
    });
  });
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
