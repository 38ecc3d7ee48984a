"""Reads the header of a netCDF file in the 64-bit offset format."""

import struct

WIDTHS = {2: 1, 4: 4, 6: 8}


class Header:
    """attributes: {name: text or number} of the file; of: {variable: attributes}; begin, count: of each variable."""

    def __init__(self, data):
        self.data, self.at = data, 8
        assert data[:4] == b"CDF\x02"
        self.sizes = [(self.text(), self.number())[1] for _ in range(self.list_length())]
        self.attributes = self.read_attributes()
        self.of, self.begin, self.count = {}, {}, {}
        for _ in range(self.list_length()):
            name = self.text()
            self.count[name] = 1
            for _ in range(self.number()):
                self.count[name] *= self.sizes[self.number()]
            self.of[name] = self.read_attributes()
            self.at += 8
            self.begin[name] = struct.unpack_from(">q", data, self.at)[0]
            self.at += 8

    def doubles(self, name):
        return struct.unpack_from(f">{self.count[name]}d", self.data, self.begin[name])

    def number(self):
        self.at += 4
        return struct.unpack_from(">i", self.data, self.at - 4)[0]

    def list_length(self):
        self.number()
        return self.number()

    def bytes(self, n):
        found = self.data[self.at:self.at + n]
        self.at += (n + 3) // 4 * 4
        return found

    def text(self):
        return self.bytes(self.number()).decode()

    def read_attributes(self):
        found = {}
        for _ in range(self.list_length()):
            name, kind, n = self.text(), self.number(), self.number()
            content = self.bytes(n * WIDTHS[kind])
            found[name] = content.decode() if kind == 2 else struct.unpack(f">{n}{'i' if kind == 4 else 'd'}", content)[0]
        return found
