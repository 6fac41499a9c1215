/** Characters that Windows, macOS or Linux do not allow in a filename, and the escape character itself. */
// eslint-disable-next-line no-control-regex -- control characters are among them
const UNSAFE = /[\u0000-\u001f\u007f<>:"/\\|?*%]|^\.|[. ]$/gu;
/** Names that Windows keeps for devices. */
const RESERVED = /^(con|prn|aux|nul|com\d|lpt\d)$/i;
/** File systems take 255 bytes of UTF-8, and an extension and a number follow. */
const MAX_BYTES = 200;

/** The filename of a document, without its extension: the key, escaped as in a URL where needed [SE-20]. */
export function fileNameOf(key: string): string {
  const escaped = (RESERVED.test(key) ? `%${hex(key[0]!)}${key.slice(1)}` : key).replace(
    UNSAFE,
    (char, offset: number) => (RESERVED.test(key) && offset === 0 ? char : `%${hex(char)}`),
  );
  if (Buffer.byteLength(escaped) <= MAX_BYTES) return escaped || '%';
  return `${cut(escaped)}%${hash(key)}`;
}

/** The key of a filename; what was cut off is not known, which the name inside makes up for. */
export function keyOfFileName(fileName: string): string {
  return fileName.replace(/%([0-9a-f]{2})/gi, (_, digits: string) =>
    String.fromCharCode(Number.parseInt(digits, 16)),
  );
}

function hex(char: string): string {
  return char.charCodeAt(0).toString(16).padStart(2, '0');
}

function cut(text: string): string {
  let length = 0;
  let cutText = '';
  for (const char of text) {
    length += Buffer.byteLength(char);
    if (length > MAX_BYTES) break;
    cutText += char;
  }
  return cutText;
}

/** FNV-1a, to tell long names apart that begin alike. */
function hash(text: string): string {
  let value = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) {
    value = Math.imul(value ^ text.charCodeAt(i), 0x01000193) >>> 0;
  }
  return value.toString(36);
}
